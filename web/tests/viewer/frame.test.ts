import { describe, expect, it } from 'vitest';

import type { Vector } from '../../src/api/types';
import { boundsOf, frameModel, frameOf, toUnit, unitPositions } from '../../src/viewer/frame';
import { kMesh, kSkeleton, randomNumbers } from '../sample';

function framed(points: readonly Vector[]): number[] {
    const { center, scale } = frameOf(points);
    return points.map(
        (point) => scale * Math.hypot(...point.map((value, axis) => value - (center[axis] ?? 0))),
    );
}

describe('frameOf', () => {
    it('takes any points just into the unit sphere', () => {
        const random = randomNumbers(7);
        for (const size of [1e-6, 1, 1e6]) {
            const points = Array.from(
                { length: 40 },
                () => [random() * size + 5 * size, random() * size, random() * 3 * size] as Vector,
            );
            expect(Math.max(...framed(points))).toBeCloseTo(1, 9);
        }
    });

    it('stays finite for a point and for nothing', () => {
        expect(frameOf([[4, 5, 6]])).toEqual({ center: [4, 5, 6], scale: 1 });
        expect(frameOf([])).toEqual({ center: [0, 0, 0], scale: 1 });
        expect(boundsOf([])).toBeNull();
    });
});

describe('frameModel', () => {
    it('goes by the mesh, and by the skeleton where there is no mesh', () => {
        expect(frameModel(kMesh, kSkeleton).center).toEqual([1.5, 0.5, 0.5]);
        expect(frameModel(null, kSkeleton).center).toEqual([1.5, 0.5, 0]);
        const empty = { ...kMesh, positions: [], triangles: [] };
        expect(frameModel(empty, kSkeleton)).toEqual(frameModel(null, kSkeleton));
    });
});

describe('toUnit', () => {
    it('keeps every place of a model far from the origin of its file', () => {
        const far: Vector = [4e6, -7e6, 3e5];
        const near = frameModel(kMesh, kSkeleton);
        const frame = frameModel({ ...kMesh, origin: far }, kSkeleton);
        expect(frame.scale).toBe(near.scale);
        const mesh = unitPositions(frame, { ...kMesh, origin: far });
        const skeleton = kSkeleton.branches.flatMap(({ points }) =>
            points.map((point) =>
                toUnit(frame, [point[0] + far[0], point[1] + far[1], point[2] + far[2]]),
            ),
        );
        const expected = unitPositions(near, kMesh);
        for (const [at, value] of mesh.entries()) {
            expect(value).toBeCloseTo(expected[at] ?? Number.NaN, 6);
        }
        const line = kSkeleton.branches.flatMap(({ points }) => points);
        for (const [at, point] of line.entries()) {
            for (const [axis, value] of toUnit(near, point).entries()) {
                expect(skeleton[at]?.[axis]).toBeCloseTo(value, 6);
            }
        }
    });

    it('takes positions from the origin of the file where none is named', () => {
        const frame = frameModel(kMesh, kSkeleton);
        expect(toUnit(frame, frame.center)).toEqual([0, 0, 0]);
        expect(toUnit(frame, [0, 0, 0], frame.center)).toEqual([0, 0, 0]);
    });
});
