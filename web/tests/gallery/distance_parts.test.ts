import { describe, expect, it } from 'vitest';

import {
    partClass,
    partNames,
    partShares,
    partsBar,
    partsLegend,
} from '../../src/gallery/distance_parts';
import { hit } from '../sample';

describe('partShares', () => {
    it('sums to one and keeps the proportions', () => {
        const shares = partShares({ skeleton: 0.3, moments: 0.1 });
        expect(shares.map(({ share }) => share)).toEqual([
            expect.closeTo(0.75, 12),
            expect.closeTo(0.25, 12),
        ]);
    });

    it('gives no share to what is negative or no number, and divides nothing by zero', () => {
        const shares = partShares({ a: -1, b: Number.NaN, c: 2, d: Number.POSITIVE_INFINITY });
        expect(shares.map(({ share }) => share)).toEqual([0, 0, 1, 0]);
        expect(partShares({ a: 0, b: 0 }).map(({ share }) => share)).toEqual([0, 0]);
        expect(partShares({})).toEqual([]);
    });

    it('keeps one order whatever order a hit names its parts in', () => {
        const names = ['skeleton', 'views'];
        const shares = partShares({ views: 1, radius: 3, skeleton: 1 }, names);
        expect(shares.map(({ name, share }) => [name, share])).toEqual([
            ['skeleton', 0.2],
            ['views', 0.2],
        ]);
    });
});

describe('partNames', () => {
    it('names each part once, known ones first', () => {
        const hits = [hit(1, { parts: { b: 1, views: 1 } }), hit(2, { parts: { a: 1, pose: 1 } })];
        expect(partNames(hits)).toEqual(['views', 'pose', 'a', 'b']);
    });

    it('leaves out what no hit has anything of', () => {
        const hits = [
            hit(1, { parts: { build: 0, skeleton: 0, pose: 0 } }),
            hit(2, { parts: { build: 0, skeleton: 1, pose: 0 } }),
        ];
        expect(partNames(hits)).toEqual(['skeleton']);
    });
});

describe('partClass', () => {
    it('is the same for a part wherever it stands, and another for those beside it', () => {
        expect(partClass('views')).toBe('part part-4');
        const rankers = [
            ['skeleton', 'skeleton_pairs', 'skeleton_layout', 'views', 'surface_pairs'],
            ['local_volume', 'radial_thickness', 'skeleton', 'build', 'pose', 'size'],
            ['code', 'length', 'unmatched', 'skeleton_pairs', 'skeleton_layout', 'build', 'pose'],
        ];
        for (const names of rankers) {
            expect(new Set(names.map(partClass)).size).toBe(names.length);
        }
        expect(partClass('unheard of')).toMatch(/^part part-\d$/);
    });
});

describe('partsBar', () => {
    it('says in words what it shows, and draws only what has a share', () => {
        const bar = partsBar({ skeleton: 0.2, moments: 0 }, ['skeleton', 'moments'], 0.5);
        expect(bar.getAttribute('aria-label')).toBe('skeleton 0.200, moments 0.000');
        expect(bar.querySelectorAll('.part')).toHaveLength(1);
    });

    it('is never longer than its track', () => {
        const length = (value: number) =>
            partsBar({ a: 1 }, ['a'], value)
                .querySelector<HTMLElement>('.parts-bar')
                ?.style.getPropertyValue('--length');
        expect(length(3)).toBe('1.0000');
        expect(length(-3)).toBe('0.0000');
    });
});

describe('partsLegend', () => {
    it('names each part, and is not there without parts', () => {
        expect(partsLegend(['chain_code'])?.textContent).toBe('chain code');
        expect(partsLegend([])).toBeNull();
    });
});
