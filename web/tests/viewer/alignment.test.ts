import { Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { expect, it } from 'vitest';

import { alignment, samplePoints } from '../../src/viewer/alignment';
import { atOnce } from '../../src/viewer/slices';
import { fitSimilarity } from '../../src/viewer/similarity_fit';
import { SurfaceDistance } from '../../src/viewer/surface_distance';
import { symmetricEigen } from '../../src/viewer/symmetric_eigen';
import { randomNumbers } from '../sample';

/** An L of two boxes with unlike arms: no rotation but none takes it to itself. */
function bracket(): Float32Array {
    const box = (min: number[], max: number[]): number[] => {
        const corner = (bits: number): number[] =>
            [0, 1, 2].map((axis) => ((bits >> axis) & 1 ? max : min)[axis] as number);
        const faces = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        return faces.flatMap(([a = 0, b = 0, c = 0, d = 0]) =>
            [a, b, c, a, c, d].flatMap((each) => corner(each)),
        );
    };
    return new Float32Array([
        ...box([0, 0, 0], [3, 0.5, 0.4]),
        ...box([0, 0.5, 0], [0.6, 1.6, 0.4]),
    ]);
}

function moved(corners: Float32Array, by: Matrix4): Float32Array {
    const result = new Float32Array(corners.length);
    for (let at = 0; at < corners.length; at += 3) {
        new Vector3().fromArray(corners, at).applyMatrix4(by).toArray(result, at);
    }
    return result;
}

const kTurn = new Quaternion().setFromEuler(new Euler(0.4, -1.9, 2.3));
const kMove = new Matrix4().compose(new Vector3(5, -2, 1), kTurn, new Vector3(0.3, 0.3, 0.3));

it('finds eigenvalues and vectors of a symmetric matrix', () => {
    const matrix = [
        [4, 1, -2],
        [1, 2, 0],
        [-2, 0, 3],
    ];
    const { values, vectors } = symmetricEigen(matrix);
    expect(values.reduce((sum, value) => sum + value, 0)).toBeCloseTo(9, 9);
    for (const [at, vector] of vectors.entries()) {
        for (const [row, factors] of matrix.entries()) {
            const image = factors.reduce((sum, factor, i) => sum + factor * (vector[i] ?? 0), 0);
            expect(image).toBeCloseTo((values[at] ?? 0) * (vector[row] ?? 0), 9);
        }
    }
    expect(values).toEqual([...values].sort((a, b) => b - a));
});

it('finds the similarity that points were moved by', () => {
    const random = randomNumbers(5);
    const from = Array.from({ length: 9 }, () => new Vector3(random(), random(), random()));
    const to = from.map((point) => point.clone().applyMatrix4(kMove));
    const found = fitSimilarity({ from, to }).toArray();
    for (const [at, entry] of kMove.toArray().entries()) {
        expect(found[at]).toBeCloseTo(entry, 6);
    }
});

it('stands points that are no more than two, or all at one place', () => {
    const at = [new Vector3(1, 2, 3), new Vector3(1, 2, 3), new Vector3(1, 2, 3)];
    for (const points of [at.slice(0, 1), at.slice(0, 2), at, []]) {
        const matrix = fitSimilarity({ from: points, to: points });
        expect(matrix.toArray().every(Number.isFinite)).toBe(true);
    }
});

it('measures to the nearest point of a surface', () => {
    const square = new SurfaceDistance([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0]);
    const nearest = new Vector3();
    expect(square.to(new Vector3(0.25, 0.5, 2), nearest)).toBeCloseTo(2, 9);
    expect(nearest.toArray()).toEqual([0.25, 0.5, 0]);
    expect(square.to(new Vector3(2, 1, 0))).toBeCloseTo(1, 9);
    expect(new SurfaceDistance([]).to(new Vector3())).toBe(Number.POSITIVE_INFINITY);
});

it('spreads samples by area, all of them on the surface', () => {
    const corners = bracket();
    const surface = new SurfaceDistance(corners);
    const points = samplePoints(corners, 100);
    expect(points).toHaveLength(100);
    expect(Math.max(...points.map((point) => surface.to(point)))).toBeLessThan(1e-5);
});

it('lays a turned, moved and smaller copy over its original, by shape alone', () => {
    const first = bracket();
    const second = moved(first, kMove);
    const { matrix, meanDistance } = atOnce(alignment(first, second, { from: [], to: [] }));
    expect(meanDistance).toBeLessThan(0.02);
    const back = new Vector3(3, 0.5, 0.4).applyMatrix4(kMove).applyMatrix4(matrix);
    expect(back.distanceTo(new Vector3(3, 0.5, 0.4))).toBeLessThan(0.1);
});

it('stands surfaces of nothing', () => {
    const none = new Float32Array();
    for (const [a, b] of [
        [none, none],
        [bracket(), none],
        [none, bracket()],
    ] as const) {
        expect(
            atOnce(alignment(a, b, { from: [], to: [] }))
                .matrix.toArray()
                .every(Number.isFinite),
        ).toBe(true);
    }
});
