import { expect, it } from 'vitest';

import { hitGrid } from '../../src/gallery/hit_grid';
import { Selection } from '../../src/page/selection';
import { hit, searchResult } from '../sample';

const kLinks = {
    hrefOf: ({ id }: { id: number }) => `#${id}`,
    likeOf: () => ({ build: '#b', pose: '#p' }),
    selection: new Selection(),
    onMore: null,
};

it('keeps the order of the hits, and measures the bars by one scale in every search', () => {
    const hits = [hit(1, { distance: 0.2 }), hit(2, { distance: 0.4 }), hit(3, { distance: 8 })];
    const grid = hitGrid(searchResult(hits), kLinks);
    const links = [...grid.querySelectorAll('a.card-link')];
    expect(links.map((link) => link.getAttribute('href'))).toEqual(['#101', '#102', '#103']);
    const lengths = [...grid.querySelectorAll<HTMLElement>('.parts-bar')].map((bar) =>
        Number(bar.style.getPropertyValue('--length')),
    );
    expect(lengths).toEqual([0.2, 0.4, 1]);
});

it('draws one line before the hits that are far, and none among parts', () => {
    const hits = [0, 0.1, 2, 3].map((distance, at) => hit(at + 1, { distance }));
    const rows = [...hitGrid(searchResult(hits), kLinks).querySelectorAll('ol > li')];
    expect(rows.map((row) => row.className)).toEqual([
        'card hit-card',
        'card hit-card',
        'cut-line',
        'card hit-card',
        'card hit-card',
    ]);
    const parts = hitGrid({ ...searchResult(hits), part: true }, kLinks);
    expect(parts.querySelector('.cut-line')).toBeNull();
});

it('stands without hits', () => {
    expect(hitGrid(searchResult([]), kLinks).querySelectorAll('a')).toHaveLength(0);
});
