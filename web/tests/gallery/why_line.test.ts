import { expect, it } from 'vitest';

import { whyLine } from '../../src/gallery/why_line';
import { hit, kSkeleton } from '../sample';

it('says how near, how much of the query has a counterpart and what differs', () => {
    const parts = { views: 0.3, skeleton_pairs: 0.05 };
    expect(whyLine(hit(1, { parts }), kSkeleton, 'related').textContent).toBe(
        'As near as models of one kind usually are. 1 of the query’s 2 branches has a counterpart; they differ most in views.',
    );
});

it('names nothing that differs where nothing does, or everything a little', () => {
    const parts = { views: 0.1, skeleton: 0.1, skeleton_pairs: 0.1, surface_pairs: 0.1 };
    expect(whyLine(hit(1, { parts }), kSkeleton, null).textContent).toBe(
        '1 of the query’s 2 branches has a counterpart.',
    );
    const same = whyLine(hit(1, { parts: { views: 0.0001 } }), kSkeleton, 'same');
    expect(same.textContent).not.toContain('differ');
});
