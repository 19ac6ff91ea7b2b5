import { expect, it } from 'vitest';

import { kRankers } from '../../src/api/elements';

import { rankerColor, rankerColorName } from '../../src/reports/ranker_color';
import sheet from '../../src/styles/tokens.css?raw';

it('has a colour in the style sheet for each ranker, light and dark', () => {
    for (const ranker of kRankers) {
        const definitions = sheet.split(`${rankerColorName(ranker)}:`).length - 1;
        expect(definitions).toBe(2);
    }
});

it('falls back where the style sheet is missing', () => {
    expect(rankerColor('hybrid')).toMatch(/^#[0-9a-f]{6}$/);
});
