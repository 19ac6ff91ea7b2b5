import { type Bone, Quaternion, Vector3 } from 'three';

import { branchOf } from './rig';

/** Something to take a limb by: `pivot` turns so that `end` goes where it is wanted. */
export interface Handle {
    /** 1, 2, … */
    number: number;
    pivot: Bone;
    end: Bone;
}

export function positionOf(bone: Bone): Vector3 {
    return bone.getWorldPosition(new Vector3());
}

/**
 * One handle for each branch that leads somewhere: all that follows it starts at its far end. Those
 * that start where their parent does cannot be turned by it.
 */
export function findHandles(bones: readonly Bone[]): Handle[] {
    const handles: Handle[] = [];
    const held = new Set<Bone>();
    for (const end of bones) {
        const pivot = end.parent as Bone | null;
        if (!pivot || held.has(pivot) || !bones.includes(pivot) || branchOf(pivot) === null) {
            continue;
        }
        if (end.position.lengthSq() > 0) {
            held.add(pivot);
            handles.push({ number: handles.length + 1, pivot, end });
        }
    }
    return handles;
}

/**
 * Where the end of a limb goes that is dragged along a ray: on the sphere that it can reach, on the
 * side that it is on; the point nearest to the ray where that misses the sphere.
 */
export function reach(
    ray: { origin: Vector3; direction: Vector3 },
    center: Vector3,
    current: Vector3,
): Vector3 {
    const radius = current.distanceTo(center);
    const along = center.clone().sub(ray.origin).dot(ray.direction);
    const nearest = ray.origin.clone().addScaledVector(ray.direction, along);
    const square = radius * radius - nearest.distanceToSquared(center);
    if (square <= 0) {
        return center.clone().addScaledVector(nearest.sub(center).normalize(), radius);
    }
    const half = Math.sqrt(square);
    const front = nearest.clone().addScaledVector(ray.direction, -half);
    const back = nearest.clone().addScaledVector(ray.direction, half);
    return front.distanceToSquared(current) <= back.distanceToSquared(current) ? front : back;
}

/** Turns bones and remembers how they were. */
export class Pose {
    private readonly rest_: Map<Bone, Quaternion>;

    constructor(bones: readonly Bone[]) {
        this.rest_ = new Map(bones.map((bone) => [bone, bone.quaternion.clone()]));
    }

    /** Whether every bone is as it was. */
    get resting(): boolean {
        return [...this.rest_].every(([bone, rest]) => bone.quaternion.equals(rest));
    }

    /** Turns the pivot so that the end looks from it towards `target`, by the shortest way. */
    swing({ pivot, end }: Handle, target: Vector3): void {
        const center = positionOf(pivot);
        const from = positionOf(end).sub(center);
        const to = target.clone().sub(center);
        if (from.lengthSq() === 0 || to.lengthSq() === 0) {
            return;
        }
        const turn = new Quaternion().setFromUnitVectors(from.normalize(), to.normalize());
        const world = pivot.getWorldQuaternion(new Quaternion());
        const parent = pivot.parent?.getWorldQuaternion(new Quaternion()) ?? new Quaternion();
        pivot.quaternion.copy(parent.invert().multiply(turn).multiply(world)).normalize();
        pivot.updateMatrixWorld(true);
    }

    reset(bones: Iterable<Bone> = this.rest_.keys()): void {
        for (const bone of bones) {
            const rest = this.rest_.get(bone);
            if (rest) {
                bone.quaternion.copy(rest);
                bone.updateMatrixWorld(true);
            }
        }
    }
}
