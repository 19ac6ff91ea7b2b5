import {
    Box3,
    Group,
    Mesh,
    type MeshStandardMaterial,
    type Object3D,
    type ShaderMaterial,
} from 'three';
import { describe, expect, it, vi } from 'vitest';

import type { Vector } from '../../src/api/types';
import { ModelScene } from '../../src/viewer/model_scene';
import { readViewerTheme } from '../../src/viewer/theme';
import { kMesh, kSkeleton } from '../sample';

function meshes(root: Object3D): Mesh[] {
    const found: Mesh[] = [];
    root.traverse((object) => {
        if (object instanceof Mesh) {
            found.push(object);
        }
    });
    return found;
}

function scene(colors: [number, string][] = [[0, '#ff0000']], mesh: typeof kMesh | null = kMesh) {
    const input = { mesh, skeleton: kSkeleton, branchColors: new Map(colors) };
    return new ModelScene(input, readViewerTheme());
}

function colorsOf(model: ModelScene): string[] {
    return model.root.children
        .filter((child): child is Mesh => child instanceof Mesh)
        .map((tube) => (tube.material as MeshStandardMaterial).color.getHexString());
}

describe('ModelScene', () => {
    it('fits the unit sphere, whatever the model’s own unit', () => {
        for (const size of [1e-3, 1, 1e4]) {
            const scaled = (values: readonly number[]) => values.map((value) => value * size);
            const model = new ModelScene(
                {
                    mesh: { ...kMesh, positions: scaled(kMesh.positions) },
                    skeleton: {
                        ...kSkeleton,
                        branches: kSkeleton.branches.map((branch) => ({
                            ...branch,
                            points: branch.points.map((point) => scaled(point) as typeof point),
                        })),
                        nodes: [],
                    },
                    branchColors: new Map(),
                },
                readViewerTheme(),
            );
            model.root.updateMatrixWorld(true);
            const bounds = new Box3().setFromObject(model.root);
            for (const corner of [...bounds.min.toArray(), ...bounds.max.toArray()]) {
                expect(Math.abs(corner)).toBeLessThan(1.05);
            }
        }
    });

    it('shows a model far from the origin of its file as it shows one near it', () => {
        const far: Vector = [4e7, -7e6, 3e5];
        const moved = ([x, y, z]: Vector): Vector => [x + far[0], y + far[1], z + far[2]];
        const model = new ModelScene(
            {
                mesh: { ...kMesh, origin: far },
                skeleton: {
                    ...kSkeleton,
                    branches: kSkeleton.branches.map((branch) => ({
                        ...branch,
                        points: branch.points.map(moved),
                    })),
                    nodes: kSkeleton.nodes.map((node) => ({
                        ...node,
                        position: moved(node.position),
                    })),
                },
                branchColors: new Map([[0, '#ff0000']]),
            },
            readViewerTheme(),
        );
        const near = meshes(scene().root);
        expect(meshes(model.root)).toHaveLength(near.length);
        for (const [at, mesh] of meshes(model.root).entries()) {
            const box = new Box3().setFromObject(mesh, true);
            const same = new Box3().setFromObject(near[at] as Mesh, true);
            expect(box.min.distanceTo(same.min)).toBeLessThan(1e-6);
            expect(box.max.distanceTo(same.max)).toBeLessThan(1e-6);
        }
    });

    it('welds and creases alike, whatever the model’s own unit', () => {
        const corners = [1e-6, 1, 1e6].map((size) => {
            const positions = kMesh.positions.map((value) => value * size);
            const model = scene([], { ...kMesh, positions });
            const surface = model.root.children.find((child) => child instanceof Group);
            return surface && meshes(surface)[0]?.geometry.getAttribute('position').count;
        });
        expect(corners).toEqual([12, 12, 12]);
    });

    it('colours matched branches, greys the others, and has a ball for each node', () => {
        const model = scene();
        expect(colorsOf(model)).toEqual(['ff0000', readViewerTheme().unmatched.slice(1)]);
        const balls = meshes(model.root).filter((mesh) => mesh.geometry.type === 'SphereGeometry');
        expect(balls).toHaveLength(kSkeleton.nodes.length);
    });

    it('thickens the branch that is pointed at, fades the others, and undoes both', () => {
        const model = scene();
        const [first, second] = model.root.children as [Mesh, Mesh];
        const width = (mesh: Mesh) => {
            mesh.geometry.computeBoundingBox();
            const { min, max } = mesh.geometry.boundingBox ?? new Box3();
            return max.z - min.z;
        };
        const before = width(first);
        model.highlight(0);
        expect(width(first)).toBeGreaterThan(1.3 * before);
        expect((second.material as MeshStandardMaterial).opacity).toBeLessThan(1);
        model.highlight(null);
        expect(width(first)).toBeCloseTo(before, 9);
        expect((second.material as MeshStandardMaterial).opacity).toBe(1);
    });

    it('ignores a branch that it does not have', () => {
        const model = scene();
        model.highlight(99);
        for (const tube of model.root.children.slice(0, 2) as Mesh[]) {
            expect((tube.material as MeshStandardMaterial).opacity).toBe(1);
        }
    });

    it('shows the colours of the file, and its own where these are not wanted', () => {
        const colours = { of: 'triangles' as const, values: [255, 0, 0, ...Array(9).fill(0)] };
        const model = scene([], { ...kMesh, colours });
        const glass = meshes(model.root).find((mesh) => mesh.userData.glass === true);
        const material = () => glass?.material as ShaderMaterial;
        const color = glass?.geometry.getAttribute('color');
        expect(model.hasColors).toBe(true);
        expect([...(color?.array.slice(0, 12) ?? [])]).toEqual([
            1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0,
        ]);
        expect(material().vertexColors).toBe(true);
        const opaque = material().uniforms.body_opacity?.value;
        model.colored = false;
        expect(material().vertexColors).toBe(false);
        expect(material().uniforms.body_opacity?.value).toBeLessThan(opaque);
        model.applyTheme(readViewerTheme());
        expect(material().vertexColors).toBe(false);
    });

    it('has no colours to show where the file has none', () => {
        const model = scene();
        model.colored = true;
        const glass = meshes(model.root).find((mesh) => mesh.userData.glass === true);
        expect(model.hasColors).toBe(false);
        expect(glass?.geometry.hasAttribute('color')).toBe(false);
        expect((glass?.material as ShaderMaterial).vertexColors).toBe(false);
    });

    it('stands without a mesh', () => {
        expect(meshes(scene([], null).root)).toHaveLength(
            kSkeleton.branches.length + kSkeleton.nodes.length,
        );
    });

    it('gives all graphics memory back', () => {
        const model = scene();
        const resources = new Set(
            meshes(model.root).flatMap((mesh) => [
                mesh.geometry,
                mesh.material as MeshStandardMaterial,
            ]),
        );
        const disposed = [...resources].map((resource) => vi.spyOn(resource, 'dispose'));
        model.dispose();
        for (const dispose of disposed) {
            expect(dispose).toHaveBeenCalledOnce();
        }
        expect(model.root.children).toHaveLength(0);
    });

    it('hides surface and nodes on demand', () => {
        const model = scene();
        model.surfaceVisible = false;
        model.nodesVisible = false;
        expect(model.root.children.filter((child) => !child.visible)).toHaveLength(2);
    });

    it('offers its polylines for picking', () => {
        const lines = scene().branchLines;
        expect(lines.map(({ id }) => id)).toEqual([0, 1]);
        expect(lines[0]?.points).toHaveLength(4);
    });
});
