import { expect, it } from 'vitest';

import { branchFile, partFile } from '../../src/gallery/part_query';
import type { PreviewMesh } from '../../src/api/elements';
import { kSkeleton } from '../sample';

type Off = { points: number[][]; triangles: number[][] };

async function read(file: File): Promise<Off> {
    const [head, counts = '', ...lines] = (await file.text()).trim().split('\n');
    expect(head).toBe('OFF');
    const [points = 0, triangles = 0] = counts.split(' ').map(Number);
    const rows = lines.map((line) => line.split(' ').map(Number));
    expect(rows).toHaveLength(points + triangles);
    return {
        points: rows.slice(0, points),
        triangles: rows.slice(points).map((row) => row.slice(1)),
    };
}

/** Every edge once in each direction. */
function isClosed({ triangles }: Off): boolean {
    const edges = triangles.flatMap(([a, b, c]) => [`${a} ${b}`, `${b} ${c}`, `${c} ${a}`]);
    return (
        new Set(edges).size === edges.length &&
        edges.every((edge) => edges.includes(edge.split(' ').reverse().join(' ')))
    );
}

/** A box of two cubes on top of each other; the upper one is part 1. */
function tower(): { mesh: PreviewMesh; labels: number[] } {
    const positions = [0, 1, 2].flatMap((z) => [0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z]);
    const wall = (low: number): number[] =>
        [0, 1, 2, 3].flatMap((at) => {
            const [a, b] = [low + at, low + ((at + 1) % 4)];
            return [a, b, b + 4, a, b + 4, a + 4];
        });
    const triangles = [0, 2, 1, 0, 3, 2, ...wall(0), ...wall(4), 8, 9, 10, 8, 10, 11];
    const bounds = { min: [0, 0, 0], max: [1, 1, 2] } as PreviewMesh['bounds'];
    return {
        mesh: { origin: [0, 0, 0], positions, triangles, colours: null, bounds },
        labels: Array.from({ length: triangles.length / 3 }, (_, at) => (at < 10 ? 0 : 1)),
    };
}

it('makes of a part a model without holes, of its own triangles and nothing else', async () => {
    const { mesh, labels } = tower();
    for (const part of [0, 1]) {
        const file = partFile('tower, part', mesh, labels, part);
        expect(file.name).toBe('tower, part.off');
        const off = await read(file);
        expect(isClosed(off)).toBe(true);
        // Ten of its own, and a fan of four over the hole.
        expect(off.triangles).toHaveLength(14);
        const heights = off.points.map(([, , z]) => z);
        expect([Math.min(...(heights as number[])), Math.max(...(heights as number[]))]).toEqual([
            part,
            part + 1,
        ]);
    }
});

it('makes of a branch a closed tube as thick as the model is there', async () => {
    const branch = kSkeleton.branches[0];
    const radii = [0.1, 0.2, 0.3, 0.1];
    const off = await read(branchFile('leg', { ...(branch as NonNullable<typeof branch>), radii }));
    expect(isClosed(off)).toBe(true);
    const across = off.points.filter(([x]) => x === 2).map(([, y = 0, z = 0]) => Math.hypot(y, z));
    expect(across).toHaveLength(12);
    for (const radius of across) {
        expect(radius).toBeCloseTo(0.3, 5);
    }
});
