import { describe, expect, it } from 'vitest';

import type { Pair } from '../../src/api/types';
import { assignBranchColors, oklch, pairColor } from '../../src/viewer/branch_colors';
import { randomNumbers, skeleton } from '../sample';

function pairs(count: number, seed: number): Pair[] {
    const random = randomNumbers(seed);
    const hits = Array.from({ length: count }, (_, index) => index).sort(() => random() - 0.5);
    return hits.map((b, a) => ({ a, b, cost: random() }));
}

const kBranches = skeleton(
    Array.from({ length: 40 }, (_, index) =>
        Array.from({ length: 2 + ((index * 7) % 11) }, (_unused, x) => [x, index, 0] as const).map(
            ([x, y, z]) => [x, y, z],
        ),
    ),
).branches;

describe('assignBranchColors', () => {
    it('gives both sides of a pair the same colour and different pairs different ones', () => {
        const matched = pairs(40, 5);
        const { query, hit, pairs: colored } = assignBranchColors(matched, kBranches);
        for (const { a, b } of matched) {
            expect(query.get(a)?.color).toBe(hit.get(b)?.color);
            expect(query.get(a)).toBe(hit.get(b));
        }
        expect(new Set(colored.map(({ color }) => color)).size).toBe(matched.length);
        expect(new Set(colored.map(({ number }) => number)).size).toBe(matched.length);
    });

    it('leaves unmatched branches without a colour', () => {
        const { query, hit } = assignBranchColors([{ a: 3, b: 8, cost: 0 }], kBranches);
        expect([...query.keys()]).toEqual([3]);
        expect([...hit.keys()]).toEqual([8]);
    });

    it('does not depend on the order of the matches', () => {
        const matched = pairs(40, 9);
        const forwards = assignBranchColors(matched, kBranches);
        const backwards = assignBranchColors([...matched].reverse(), kBranches);
        expect(backwards.pairs).toEqual(forwards.pairs);
    });

    it('numbers the longest branches of the query first', () => {
        const { pairs: colored } = assignBranchColors(pairs(40, 2), kBranches);
        const lengths = colored.map(({ a }) => kBranches[a]?.length ?? 0);
        expect(lengths).toEqual([...lengths].sort((x, y) => y - x));
    });

    it('copes with no match and with branches that it does not know', () => {
        expect(assignBranchColors([], []).pairs).toEqual([]);
        expect(assignBranchColors([{ a: 99, b: 0, cost: 1 }], []).query.has(99)).toBe(true);
    });
});

describe('pairColor', () => {
    it('keeps the first dozen clearly apart', () => {
        const rgb = Array.from({ length: 12 }, (_, index) => {
            const color = pairColor(index);
            return [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16));
        });
        for (const [index, one] of rgb.entries()) {
            for (const other of rgb.slice(index + 1)) {
                const distance = Math.hypot(...one.map((value, at) => value - (other[at] ?? 0)));
                expect(distance).toBeGreaterThan(40);
            }
        }
    });

    it('is a colour that style sheets understand', () => {
        for (let index = 0; index < 200; index++) {
            expect(pairColor(index)).toMatch(/^#[0-9a-f]{6}$/);
        }
    });
});

describe('oklch', () => {
    it('meets black, white and grey', () => {
        expect(oklch(0, 0, 0)).toBe('#000000');
        expect(oklch(1, 0, 0)).toBe('#ffffff');
        const grey = oklch(0.5, 0, 77);
        expect(grey.slice(1, 3)).toBe(grey.slice(3, 5));
        expect(grey.slice(3, 5)).toBe(grey.slice(5, 7));
    });

    it('meets pure red, whose coordinates are known', () => {
        expect(oklch(0.62796, 0.25768, 29.2339)).toBe('#ff0000');
    });
});
