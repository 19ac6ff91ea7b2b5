import { describe, expect, it } from 'vitest';

import type { Vector } from '../../src/api/types';
import { distanceToSegment } from '../../src/viewer/pick';
import { buildTube } from '../../src/viewer/tube';
import { randomNumbers } from '../sample';

function vertices(values: Float32Array): Vector[] {
    return Array.from({ length: values.length / 3 }, (_, at) => [
        values[3 * at] ?? Number.NaN,
        values[3 * at + 1] ?? Number.NaN,
        values[3 * at + 2] ?? Number.NaN,
    ]);
}

function helix(count: number): Vector[] {
    return Array.from({ length: count }, (_, at) => [Math.cos(at / 4), at / 10, Math.sin(at / 4)]);
}

describe('buildTube', () => {
    it('keeps each vertex at the radius from its ring’s centre, square to the normal', () => {
        const line = helix(30);
        const sides = 8;
        const { positions, normals } = buildTube(line, 0.05, sides);
        for (const [index, point] of vertices(positions).entries()) {
            const center = line[Math.floor(index / sides)] as Vector;
            expect(
                Math.hypot(...point.map((value, axis) => value - (center[axis] ?? 0))),
            ).toBeCloseTo(0.05, 5);
        }
        for (const normal of vertices(normals)) {
            expect(Math.hypot(...normal)).toBeCloseTo(1, 5);
        }
    });

    it('names only vertices that exist, each triangle three different ones', () => {
        const { positions, indices } = buildTube(helix(12), 0.1, 6);
        expect(indices.length).toBe(11 * 6 * 2 * 3);
        for (let at = 0; at < indices.length; at += 3) {
            const corners = [...indices.slice(at, at + 3)];
            expect(new Set(corners).size).toBe(3);
            expect(Math.max(...corners)).toBeLessThan(positions.length / 3);
        }
    });

    it('is wound outwards', () => {
        const { positions, normals, indices } = buildTube(helix(12), 0.1, 6);
        const at = vertices(positions);
        const outwards = vertices(normals);
        for (let index = 0; index < indices.length; index += 3) {
            const [a, b, c] = [0, 1, 2].map((k) => at[indices[index + k] ?? 0] as Vector) as [
                Vector,
                Vector,
                Vector,
            ];
            const u = b.map((value, axis) => value - (a[axis] ?? 0)) as Vector;
            const v = c.map((value, axis) => value - (a[axis] ?? 0)) as Vector;
            const face: Vector = [
                u[1] * v[2] - u[2] * v[1],
                u[2] * v[0] - u[0] * v[2],
                u[0] * v[1] - u[1] * v[0],
            ];
            const normal = outwards[indices[index] ?? 0] as Vector;
            expect(face[0] * normal[0] + face[1] * normal[1] + face[2] * normal[2]).toBeGreaterThan(
                0,
            );
        }
    });

    it('does not twist: neighbouring rings meet vertex by vertex', () => {
        const line = helix(60);
        const sides = 8;
        const points = vertices(buildTube(line, 0.05, sides).positions);
        for (let index = 0; index + sides < points.length; index++) {
            const [one, next] = [points[index] as Vector, points[index + sides] as Vector];
            const step = Math.hypot(...one.map((value, axis) => value - (next[axis] ?? 0)));
            expect(step).toBeLessThan(0.32);
        }
    });

    it.each<[string, Vector[]]>([
        ['nothing', []],
        ['one point', [[1, 2, 3]]],
        ['one point again and again', Array.from({ length: 5 }, (): Vector => [1, 2, 3])],
        [
            'no numbers',
            [
                [Number.NaN, 0, 0],
                [0, Number.POSITIVE_INFINITY, 0],
            ],
        ],
    ])('is empty for %s', (_, line) => {
        const { positions, indices } = buildTube(line, 0.1);
        expect(positions).toHaveLength(0);
        expect(indices).toHaveLength(0);
    });

    it('stays finite on repeated points, straight lines, sharp turns and closed loops', () => {
        const random = randomNumbers(3);
        const lines: Vector[][] = [
            [
                [0, 0, 0],
                [0, 0, 0],
                [1, 0, 0],
                [1, 0, 0],
            ],
            [
                [0, 0, 0],
                [1, 0, 0],
                [0, 0, 0],
            ],
            [
                [0, 0, 0],
                [0, 1, 0],
                [0, 2, 0],
            ],
            [
                [0, 0, 0],
                [1, 0, 0],
                [1, 1, 0],
                [0, 0, 0],
            ],
            Array.from({ length: 50 }, () => [random(), random(), random()] as Vector),
        ];
        for (const line of lines) {
            const { positions, normals } = buildTube(line, 0.1);
            expect(positions.length).toBeGreaterThan(0);
            expect([...positions, ...normals].every(Number.isFinite)).toBe(true);
        }
    });
});

describe('distanceToSegment on a tube’s outline', () => {
    it('agrees with the tube’s radius in the plane of a straight line', () => {
        const { positions } = buildTube(
            [
                [0, 0, 0],
                [4, 0, 0],
            ],
            0.25,
            4,
        );
        for (const [x, y, z] of vertices(positions)) {
            const away = distanceToSegment(
                { x, y: Math.hypot(y, z) },
                { x: 0, y: 0 },
                { x: 4, y: 0 },
            );
            expect(away).toBeCloseTo(0.25, 6);
        }
    });
});
