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

type Turns = readonly Quaternion[];

/** Turns are told in so many steps a unit: a tenth of a degree. */
const kSteps = 1000;
const kMostSteps = 200;

/** Turns bones, remembers how they were, and takes back what was done to them. */
export class Pose {
    private readonly bones_: readonly Bone[];
    private readonly rest_: Map<Bone, Quaternion>;
    private done_: Turns[] = [];
    private undone_: Turns[] = [];
    /** As it was after the last thing that was done. */
    private now_: Turns;

    constructor(bones: readonly Bone[]) {
        this.bones_ = bones;
        this.now_ = this.turns;
        this.rest_ = new Map(bones.map((bone) => [bone, bone.quaternion.clone()]));
    }

    get canUndo(): boolean {
        return this.done_.length > 0;
    }

    get canRedo(): boolean {
        return this.undone_.length > 0;
    }

    /** What was done since the last call is one step. False where that was nothing. */
    commit(): boolean {
        const { turns } = this;
        if (turns.every((turn, at) => turn.equals(this.now_[at] as Quaternion))) {
            return false;
        }
        this.done_ = [...this.done_, this.now_].slice(-kMostSteps);
        this.undone_ = [];
        this.now_ = turns;
        return true;
    }

    undo(): void {
        this.step(this.done_, this.undone_);
    }

    redo(): void {
        this.step(this.undone_, this.done_);
    }

    /** The bones that are turned, for an address: `2.120.-500.0~7.0.0.300`; empty at rest. */
    get text(): string {
        return this.bones_
            .flatMap((bone, at) => {
                const rest = this.rest_.get(bone);
                if (!rest || bone.quaternion.angleTo(rest) * kSteps < 1) {
                    return [];
                }
                const { x, y, z, w } = bone.quaternion;
                // A turn and its negative are the same one.
                const sign = w < 0 ? -kSteps : kSteps;
                return [[at, ...[x, y, z].map((part) => Math.round(part * sign))].join('.')];
            })
            .join('~');
    }

    /** Takes any text; what makes no sense turns nothing. */
    set text(text: string) {
        this.reset();
        for (const [, at, ...parts] of text.matchAll(/(\d+)\.(-?\d+)\.(-?\d+)\.(-?\d+)/g)) {
            const bone = this.bones_[Number(at)];
            const [x, y, z] = parts.map((part) => Number(part) / kSteps) as [
                number,
                number,
                number,
            ];
            const rest = 1 - x * x - y * y - z * z;
            // Rounding may take it a little beyond 1.
            if (bone && rest > -0.01) {
                bone.quaternion.set(x, y, z, Math.sqrt(Math.max(0, rest))).normalize();
                bone.updateMatrixWorld(true);
            }
        }
        this.now_ = this.turns;
    }

    private get turns(): Turns {
        return this.bones_.map((bone) => bone.quaternion.clone());
    }

    private step(from: Turns[], to: Turns[]): void {
        const turns = from.pop();
        if (turns) {
            to.push(this.now_);
            this.now_ = turns;
            for (const [at, bone] of this.bones_.entries()) {
                bone.quaternion.copy(turns[at] as Quaternion);
                bone.updateMatrixWorld(true);
            }
        }
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
