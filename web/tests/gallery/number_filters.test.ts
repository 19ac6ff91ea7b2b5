import { describe, expect, it } from 'vitest';

import { nameOfCounts, nameOfSides } from '../../src/gallery/number_filters';

describe('ranges', () => {
    it.each([
        ['0', '0'],
        ['5-8', '5–8'],
        ['129-', '129 and more'],
    ])('of counts read well: %s', (range, name) => {
        expect(nameOfCounts(range)).toBe(name);
    });

    it.each([
        ['0-0.001mm', '0–0.001 mm'],
        ['10-100mm', '10–100 mm'],
        ['100-1000mm', '100–1,000 mm'],
        ['1000-10000mm', '1–10 m'],
        ['1000000-mm', '1 km and more'],
        ['10-100', '10–100 (no unit)'],
        ['1000000-', '1,000,000 and more (no unit)'],
    ])('of sides are in the unit that one would say them in: %s', (range, name) => {
        expect(nameOfSides(range)).toBe(name);
    });
});
