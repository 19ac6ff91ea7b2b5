import { expect, it } from 'vitest';

import { hitGrid } from '../../src/gallery/hit_grid';
import { Selection } from '../../src/page/selection';
import { hit, searchResult } from '../sample';

const kLinks = {
    hrefOf: ({ id }: { id: number }) => `#${id}`,
    likeOf: () => ({ build: '#b', pose: '#p' }),
    selection: new Selection(),
    onMore: null,
    order: 'distance' as const,
};

it('keeps the order of the hits, and measures the bars by one scale in every search', () => {
    const hits = [hit(1, { distance: 0.2 }), hit(2, { distance: 0.4 }), hit(3, { distance: 8 })];
    const grid = hitGrid(searchResult(hits), kLinks).node;
    const links = [...grid.querySelectorAll('a.card-link')];
    expect(links.map((link) => link.getAttribute('href'))).toEqual(['#101', '#102', '#103']);
    const lengths = [...grid.querySelectorAll<HTMLElement>('.parts-bar')].map((bar) =>
        Number(bar.style.getPropertyValue('--length')),
    );
    expect(lengths).toEqual([0.2, 0.4, 1]);
});

it('draws one line before the hits that are far, and none among parts', () => {
    const hits = [0, 0.1, 2, 3].map((distance, at) => hit(at + 1, { distance }));
    const rows = [...hitGrid(searchResult(hits), kLinks).node.querySelectorAll('ol > li')];
    expect(rows.map((row) => row.className)).toEqual([
        'card hit-card',
        'card hit-card',
        'cut-line',
        'card hit-card',
        'card hit-card',
    ]);
    const parts = hitGrid({ ...searchResult(hits), part: true }, kLinks).node;
    expect(parts.querySelector('.cut-line')).toBeNull();
});

it('stands without hits', () => {
    expect(hitGrid(searchResult([]), kLinks).node.querySelectorAll('a')).toHaveLength(0);
});

it('adds many hits a few at a time, and has no line between kinds in another order', async () => {
    const hits = Array.from({ length: 30 }, (_, at) => hit(at + 1, { distance: at }));
    const { node, whole } = hitGrid(searchResult(hits), { ...kLinks, order: 'name' });
    document.body.append(node);
    expect(node.querySelectorAll('.hit-card').length).toBeLessThan(13);
    await whole;
    expect(node.querySelectorAll('.hit-card')).toHaveLength(30);
    expect(node.querySelector('.cut-line')).toBeNull();
    expect(node.querySelector('ol')?.getAttribute('aria-label')).toBe('Hits by: Name');
    node.remove();
    const shown = hitGrid(searchResult(hits), { ...kLinks, first: 24 }).node;
    expect(shown.querySelectorAll('.hit-card')).toHaveLength(24);
});
