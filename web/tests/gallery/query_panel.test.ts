import { expect, it } from 'vitest';

import { queryPanel } from '../../src/gallery/query_panel';
import { kMesh, searchResult } from '../sample';

it('shows figures and notes, and says plainly where there is no WebGL', async () => {
    const panel = queryPanel();
    const query = {
        ...searchResult().query,
        vertices: 12345,
        warnings: [{ code: 'degenerate_face', count: 3, message: '3 degenerate faces' }],
    };
    await panel.show(query, {
        mesh: kMesh,
        up: 'y',
        partsHref: '#/models/7/parts',
        lookHref: '#/models/7/look',
        takeAway: null,
    });
    expect(panel.node.textContent).toContain('12,345');
    expect(panel.node.textContent).toContain('3 degenerate faces');
    expect(panel.node.querySelector('.no-webgl')).not.toBeNull();
    expect([...panel.node.querySelectorAll('a')].map((a) => a.getAttribute('href'))).toEqual([
        '#/models/7/look',
        '#/models/7/parts',
    ]);
    panel.dispose();
});

it('says how large the query is, in the unit of its file', async () => {
    const panel = queryPanel();
    const query = { ...searchResult().query, unit: 'mm' };
    await panel.show(query, {
        mesh: kMesh,
        up: 'y',
        partsHref: null,
        lookHref: '#',
        takeAway: null,
    });
    expect(panel.node.textContent).toContain('3 × 1 × 1 mm');
    panel.dispose();
});

it('shows nothing any more after it was taken down', async () => {
    const panel = queryPanel();
    const shown = panel.show(searchResult().query, {
        mesh: kMesh,
        up: 'y',
        partsHref: null,
        lookHref: '#/models/7/look',
        takeAway: null,
    });
    panel.dispose();
    await shown;
    expect(panel.node.querySelector('.no-webgl')).toBeNull();
});
