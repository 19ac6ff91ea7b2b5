import { describe, expect, it } from 'vitest';

import type { Point } from '../../src/api/types';
import { boundsOf, frameModel, frameOf } from '../../src/viewer/frame';
import { kMesh, kSkeleton, randomNumbers } from '../sample';

function framed(points: readonly Point[]): number[] {
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
                () => [random() * size + 5 * size, random() * size, random() * 3 * size] as Point,
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
