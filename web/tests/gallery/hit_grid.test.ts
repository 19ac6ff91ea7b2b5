import { expect, it } from 'vitest';

import { hitGrid } from '../../src/gallery/hit_grid';
import { hit } from '../sample';

it('keeps the order of the hits, and measures the bars against the longest', () => {
    const hits = [hit(1, { distance: 0.2 }), hit(2, { distance: 0.4 }), hit(3, { distance: 0.8 })];
    const grid = hitGrid(
        hits,
        ({ id }) => `#${id}`,
        () => ({ build: '#b', pose: '#p' }),
    );
    const links = [...grid.querySelectorAll('a.card-link')];
    expect(links.map((link) => link.getAttribute('href'))).toEqual(['#101', '#102', '#103']);
    const lengths = [...grid.querySelectorAll<HTMLElement>('.parts-bar')].map((bar) =>
        Number(bar.style.getPropertyValue('--length')),
    );
    expect(lengths).toEqual([0.25, 0.5, 1]);
});

it('stands without hits', () => {
    expect(
        hitGrid(
            [],
            () => '#',
            () => ({ build: '#b', pose: '#p' }),
        ).querySelectorAll('a'),
    ).toHaveLength(0);
});
