import {
    BufferAttribute,
    BufferGeometry,
    Color,
    DoubleSide,
    Group,
    type Material,
    Mesh,
    MeshBasicMaterial,
    MeshStandardMaterial,
    type Raycaster,
    type ShaderMaterial,
    SkinnedMesh,
} from 'three';
import { toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js';

import type { Skeleton, Vector } from '../api/types';
import { disposeBelow } from './dispose';
import { frameOf } from './frame';
import { positionOf } from './pose';
import { branchOf, type Rig } from './rig';
import { surfaceMaterial } from './surface_material';
import type { ViewerTheme } from './theme';
import { buildTube } from './tube';

const kTubeRadius = 0.008;
const kCreaseAngle = Math.PI / 4.5;
const kFaded = 0.72;

export interface RigSceneInput {
    rig: Rig;
    skeleton: Skeleton;
    /** `#rrggbb` by the number of the part. */
    colors: readonly string[];
}

interface Part {
    solid: SkinnedMesh<BufferGeometry, MeshStandardMaterial>;
    glass: SkinnedMesh<BufferGeometry, ShaderMaterial>;
    color: string;
}

function pointsOf(parts: readonly SkinnedMesh<BufferGeometry>[]): Vector[] {
    const points: Vector[] = [];
    for (const { geometry } of parts) {
        const positions = geometry.getAttribute('position');
        for (let at = 0; at < positions.count; at++) {
            points.push([positions.getX(at), positions.getY(at), positions.getZ(at)]);
        }
    }
    return points;
}

/**
 * A rigged model in the unit sphere: each part solid in its colour, or all of them as glass, and
 * the branches of the skeleton, which turn with their bones. Owns all that it shows until
 * {@link dispose}.
 */
export class RigScene {
    readonly root = new Group();
    private readonly parts_: Part[] = [];
    private readonly depths_: SkinnedMesh[] = [];
    private readonly tubes_: Mesh<BufferGeometry, MeshStandardMaterial>[] = [];
    private theme_: ViewerTheme;
    private colored_ = true;
    private boundsAreOld_ = false;
    private highlighted_: number | null = null;

    constructor(input: RigSceneInput, theme: ViewerTheme) {
        this.theme_ = theme;
        const { center, scale } = frameOf(pointsOf(input.rig.parts));
        this.settle(input.rig);
        this.addTubes(input, scale);
        for (const [index, mesh] of input.rig.parts.entries()) {
            this.addPart(mesh, input.colors[index] ?? theme.unmatched);
        }
        this.root.scale.setScalar(scale);
        this.root.position.set(-center[0] * scale, -center[1] * scale, -center[2] * scale);
        this.root.updateMatrixWorld(true);
        this.colored = true;
    }

    /** Whether each part has its colour; otherwise the model is glass. */
    set colored(on: boolean) {
        this.colored_ = on;
        for (const { solid, glass } of this.parts_) {
            solid.visible = on;
            glass.visible = !on;
        }
        for (const depth of this.depths_) {
            depth.visible = !on;
        }
        for (const { material } of this.tubes_) {
            // Drawn over a solid surface, which hides it, and before a glass one.
            material.depthTest = !on;
            material.transparent = on;
            material.needsUpdate = true;
        }
        this.paint();
    }

    set skeletonVisible(visible: boolean) {
        for (const tube of this.tubes_) {
            tube.visible = visible;
        }
    }

    /** Lets all parts but one fade; null ends it. */
    highlight(part: number | null): void {
        this.highlighted_ = part;
        this.paint();
    }

    applyTheme(theme: ViewerTheme): void {
        this.theme_ = theme;
        for (const { glass } of this.parts_) {
            glass.material.dispose();
            glass.material = surfaceMaterial(theme.surface);
        }
        this.paint();
    }

    /** Bones have moved: what is known of where the surface lies holds no more. */
    moved(): void {
        this.boundsAreOld_ = true;
    }

    /** The part that a ray meets first; null: none, or none is told from another. */
    partAt(ray: Raycaster): number | null {
        if (!this.colored_) {
            return null;
        }
        if (this.boundsAreOld_) {
            this.boundsAreOld_ = false;
            for (const { solid } of this.parts_) {
                solid.computeBoundingSphere();
            }
        }
        const [hit] = ray.intersectObjects(
            this.parts_.map(({ solid }) => solid),
            false,
        );
        const part = this.parts_.findIndex(({ solid }) => solid === hit?.object);
        return part < 0 ? null : part;
    }

    dispose(): void {
        disposeBelow(this.root);
    }

    private paint(): void {
        const ground = new Color(this.theme_.faded);
        for (const [index, { solid, color }] of this.parts_.entries()) {
            const faded = this.highlighted_ !== null && this.highlighted_ !== index;
            solid.material.color = new Color(color).lerp(ground, faded ? kFaded : 0);
        }
        for (const { material } of this.tubes_) {
            material.color = new Color(this.colored_ ? this.theme_.node : this.theme_.accent);
        }
    }

    /** Brings bones and surface together about the vertices' zero, near which floats are fine. */
    private settle({ root, origin, parts }: Rig): void {
        root.position.set(-origin[0], -origin[1], -origin[2]);
        // A skinned mesh lies where its bones take it, whatever it hangs on: on nothing far away.
        for (const part of parts) {
            part.position.set(0, 0, 0);
            part.quaternion.identity();
            part.scale.set(1, 1, 1);
        }
        this.root.add(root, ...parts);
        root.updateMatrixWorld(true);
    }

    private addPart(mesh: SkinnedMesh<BufferGeometry>, color: string): void {
        const smooth = mesh.geometry;
        const geometry = toCreasedNormals(smooth, kCreaseAngle);
        smooth.dispose();
        (mesh.material as Material).dispose();
        mesh.geometry = geometry;
        const solid = mesh as Part['solid'];
        solid.material = new MeshStandardMaterial({ roughness: 0.78, side: DoubleSide });
        const depth = this.twin(
            solid,
            new MeshBasicMaterial({ colorWrite: false, side: DoubleSide, transparent: true }),
        );
        depth.renderOrder = 1;
        const glass = this.twin(solid, surfaceMaterial(this.theme_.surface));
        glass.renderOrder = 2;
        this.depths_.push(depth);
        this.parts_.push({ solid, glass, color });
        // Where it is drawn depends on the bones, which the bounds of the geometry know nothing of.
        solid.frustumCulled = false;
    }

    private twin<M extends Material>(
        solid: Part['solid'],
        material: M,
    ): SkinnedMesh<BufferGeometry, M> {
        const twin = new SkinnedMesh(solid.geometry, material);
        twin.bind(solid.skeleton, solid.bindMatrix);
        twin.frustumCulled = false;
        solid.parent?.add(twin);
        return twin;
    }

    private addTubes({ rig, skeleton }: RigSceneInput, scale: number): void {
        for (const bone of rig.bones) {
            const id = branchOf(bone);
            const branch = skeleton.branches.find((each) => each.id === id);
            if (!branch) {
                continue;
            }
            const from = positionOf(bone);
            const line = branch.points.map(
                ([x, y, z]): Vector => [
                    x - rig.origin[0] - from.x,
                    y - rig.origin[1] - from.y,
                    z - rig.origin[2] - from.z,
                ],
            );
            const { positions, normals, indices } = buildTube(line, kTubeRadius / scale);
            const geometry = new BufferGeometry();
            geometry.setAttribute('position', new BufferAttribute(positions, 3));
            geometry.setAttribute('normal', new BufferAttribute(normals, 3));
            geometry.setIndex(new BufferAttribute(indices, 1));
            const material = new MeshStandardMaterial({ roughness: 0.6 });
            const tube = new Mesh(geometry, material);
            tube.renderOrder = 5;
            bone.add(tube);
            this.tubes_.push(tube);
        }
    }
}
