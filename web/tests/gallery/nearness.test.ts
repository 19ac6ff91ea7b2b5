import { expect, it } from 'vitest';

import { kRankers } from '../../src/api/elements';
import { nearnessOf } from '../../src/gallery/nearness';

it('goes from the same to far, and never back', () => {
    const order = ['same', 'very close', 'related', 'far'];
    for (const ranker of kRankers) {
        const words = [0, 0.0005, 0.1, 0.3, 0.6, 0.9, 5].map((distance) =>
            order.indexOf(String(nearnessOf(distance, { ranker, part: false }))),
        );
        expect(words).toEqual([...words].sort());
        expect(words[0]).toBe(0);
        expect(words.at(-1)).toBe(3);
    }
});

it('has no word for parts, nor for what is no distance', () => {
    expect(nearnessOf(0.1, { ranker: 'hybrid', part: true })).toBeNull();
    expect(nearnessOf(Number.NaN, { ranker: 'hybrid', part: false })).toBeNull();
});
