import { expect, it } from 'vitest';

import { colorDistance, oklab, partColors } from '../../src/viewer/part_colors';

function part(index: number, neighbors: number[]) {
    return {
        part: index,
        colour: '#000000',
        triangles: 1,
        area: 1,
        area_share: 0.1,
        branch: null,
        neighbors,
    };
}

it('measures colours as they look', () => {
    expect(oklab('#ffffff')[0]).toBeCloseTo(1, 3);
    expect(oklab('#000000')[0]).toBeCloseTo(0, 3);
    expect(colorDistance('#ff0000', '#ff0000')).toBe(0);
    expect(colorDistance('#ff0000', '#00ff00')).toBeGreaterThan(
        colorDistance('#ff0000', '#ff8000'),
    );
});

it('gives twelve parts twelve colours', () => {
    const colors = partColors(Array.from({ length: 12 }, (_, index) => part(index, [])));
    expect(new Set(colors).size).toBe(12);
});

it('keeps parts that touch apart, however many there are', () => {
    const ring = Array.from({ length: 60 }, (_, index) =>
        part(index, [(index + 59) % 60, (index + 1) % 60]),
    );
    const colors = partColors(ring);
    for (const [index, { neighbors }] of ring.entries()) {
        for (const other of neighbors) {
            expect(colorDistance(colors[index] ?? '', colors[other] ?? '')).toBeGreaterThan(0.1);
        }
    }
});

it('finds a colour for a part that touches all others', () => {
    const star = Array.from({ length: 30 }, (_, index) =>
        part(index, index === 29 ? Array.from({ length: 29 }, (_, other) => other) : [29]),
    );
    expect(partColors(star)[29]).toMatch(/^#[0-9a-f]{6}$/);
});
