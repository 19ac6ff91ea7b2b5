import {
    Box3,
    Mesh,
    type MeshStandardMaterial,
    type Object3D,
    Raycaster,
    SkinnedMesh,
    Vector3,
} from 'three';
import { describe, expect, it, vi } from 'vitest';

import type { Vector } from '../../src/api/types';
import { findHandles, Pose } from '../../src/viewer/pose';
import { loadRig } from '../../src/viewer/rig';
import { RigScene } from '../../src/viewer/rig_scene';
import { readViewerTheme } from '../../src/viewer/theme';
import { rigFile } from '../rig_sample';
import { kSkeleton } from '../sample';

async function made() {
    const rig = await loadRig(rigFile());
    const colors = ['#aa0000', '#00aa00'];
    const scene = new RigScene({ rig, skeleton: kSkeleton, colors }, readViewerTheme());
    return { rig, scene };
}

/** Where a vertex of a part is drawn. */
function vertex(mesh: SkinnedMesh, index: number): Vector3 {
    const point = new Vector3().fromBufferAttribute(mesh.geometry.getAttribute('position'), index);
    return mesh.applyBoneTransform(index, point).applyMatrix4(mesh.matrixWorld);
}

function tubesOf(root: Object3D): Mesh[] {
    const tubes: Mesh[] = [];
    root.traverse((object) => {
        if (object instanceof Mesh && !(object instanceof SkinnedMesh)) {
            tubes.push(object);
        }
    });
    return tubes;
}

const colorOf = (mesh: SkinnedMesh) => (mesh.material as MeshStandardMaterial).color.getHexString();

describe('RigScene', () => {
    it('colours each part, and shows glass without parts', async () => {
        const { rig, scene } = await made();
        expect(rig.parts.map(colorOf)).toEqual(['aa0000', '00aa00']);
        scene.colored = false;
        expect(rig.parts.map((part) => part.visible)).toEqual([false, false]);
        scene.root.updateMatrixWorld(true);
        const shown: Mesh[] = [];
        scene.root.traverseVisible((object) => {
            if (object instanceof SkinnedMesh) {
                shown.push(object);
            }
        });
        expect(shown).toHaveLength(4);
    });

    it('moves the vertices of the limb that is turned and no others, and back', async () => {
        const { rig, scene } = await made();
        const [first, second] = rig.parts as [SkinnedMesh, SkinnedMesh];
        const before = [vertex(first, 1), vertex(second, 1)];
        const elbow = findHandles(rig.bones)[1];
        const pose = new Pose(rig.bones);
        if (elbow) {
            pose.swing(elbow, new Vector3(0, 9, 0));
        }
        scene.moved();
        expect(vertex(first, 1).distanceTo(before[0] as Vector3)).toBeLessThan(1e-9);
        expect(vertex(second, 1).distanceTo(before[1] as Vector3)).toBeGreaterThan(0.5);
        pose.reset();
        expect(vertex(second, 1).distanceTo(before[1] as Vector3)).toBeLessThan(1e-9);
    });

    it('finds the part under a ray, where it has moved to', async () => {
        const { rig, scene } = await made();
        const [, second] = rig.parts as [SkinnedMesh, SkinnedMesh];
        const middle = (): Vector3 =>
            [0, 1, 2]
                .reduce((sum, index) => sum.add(vertex(second, index)), new Vector3())
                .divideScalar(3);
        const at = (point: Vector3) =>
            scene.partAt(new Raycaster(point.clone().setZ(point.z + 3), new Vector3(0, 0, -1)));
        const rest = middle();
        expect(at(rest)).toBe(1);
        const elbow = findHandles(rig.bones)[1];
        if (elbow) {
            new Pose(rig.bones).swing(elbow, new Vector3(0, 9, 0));
        }
        scene.moved();
        expect(at(middle())).toBe(1);
        expect(at(rest)).not.toBe(1);
    });

    it('fades all parts but one, and ends it', async () => {
        const { rig, scene } = await made();
        scene.highlight(1);
        expect(rig.parts.map(colorOf)[0]).not.toBe('aa0000');
        expect(rig.parts.map(colorOf)[1]).toBe('00aa00');
        scene.highlight(null);
        expect(rig.parts.map(colorOf)).toEqual(['aa0000', '00aa00']);
    });

    it('shows a model far from the origin of its file as it shows one near it', async () => {
        const far: Vector = [4e7, -7e6, 3e5];
        const moved = ([x, y, z]: Vector): Vector => [x + far[0], y + far[1], z + far[2]];
        const branches = kSkeleton.branches.map((branch) => ({
            ...branch,
            points: branch.points.map(moved),
        }));
        const rig = await loadRig(rigFile({ origin: far }));
        const scene = new RigScene(
            { rig, skeleton: { ...kSkeleton, branches }, colors: [] },
            readViewerTheme(),
        );
        scene.root.updateMatrixWorld(true);
        const near = await made();
        near.scene.root.updateMatrixWorld(true);
        for (const [part, mesh] of rig.parts.entries()) {
            const same = near.rig.parts[part] as SkinnedMesh;
            for (const corner of [0, 1, 2]) {
                expect(vertex(mesh, corner).distanceTo(vertex(same, corner))).toBeLessThan(1e-6);
            }
            // What the graphics card is given: all of it as floats.
            for (const matrix of [
                mesh.matrixWorld,
                ...mesh.skeleton.bones.map((b) => b.matrixWorld),
            ]) {
                expect(Math.max(...matrix.elements.map(Math.abs))).toBeLessThan(10);
            }
        }
        const tubes = (root: typeof scene.root) =>
            tubesOf(root).map((tube) => new Box3().setFromObject(tube, true));
        for (const [at, box] of tubes(scene.root).entries()) {
            const same = tubes(near.scene.root)[at] as Box3;
            expect(box.min.distanceTo(same.min)).toBeLessThan(1e-6);
            expect(box.max.distanceTo(same.max)).toBeLessThan(1e-6);
        }
        expect(tubesOf(scene.root)).toHaveLength(2);
    });

    it('gives all graphics memory back', async () => {
        const { scene } = await made();
        const seen = new Set<{ dispose(): void }>();
        scene.root.traverse((object) => {
            if (object instanceof Mesh) {
                seen.add(object.geometry);
                seen.add(object.material);
            }
        });
        const disposed = [...seen].map((resource) => vi.spyOn(resource, 'dispose'));
        scene.dispose();
        for (const dispose of disposed) {
            expect(dispose).toHaveBeenCalledOnce();
        }
    });
});
