import { afterEach, expect, it, vi } from 'vitest';

import { unreachable } from '../../src/api/problem';
import { kSearchDefaults } from '../../src/api/search_parameters';
import { resultsPage } from '../../src/gallery/results_page';
import type { Page } from '../../src/page/context';
import { type Route, resultsOf } from '../../src/page/routes';
import { contextWith, hit, kMesh, kSkeleton, model, searchResult, settled } from '../sample';

type ResultsRoute = Extract<Route, { page: 'results' }>;

let page: Page | null = null;

afterEach(() => {
    page?.dispose();
    page = null;
});

const kModel = { kind: 'model', id: 7 } as const;
const route = (hitId: number | null = null, pose = 0.15) =>
    resultsOf(
        kModel,
        { ...kSearchDefaults, pose },
        hitId === null ? null : { kind: 'hit', id: hitId },
    ) as ResultsRoute;

function client() {
    return {
        similar: vi.fn(async () => searchResult([hit(1), hit(2), hit(3)])),
        mesh: vi.fn(async () => kMesh),
        skeleton: vi.fn(async () => kSkeleton),
        model: vi.fn(async () => model(7)),
    };
}

it('shows the hits of a model of the collection', async () => {
    const context = contextWith(client());
    page = resultsPage(route(), context);
    expect(page.node.querySelectorAll('.card-loading').length).toBeGreaterThan(0);
    await settled();
    expect(page.node.querySelectorAll('.hit-card')).toHaveLength(3);
    expect(page.node.querySelector('h1')?.textContent).toBe('Models like elephant');
    expect(context.announced.at(-1)).toContain('3 hits');
});

it('opens and closes the comparison without asking again', async () => {
    const server = client();
    page = resultsPage(route(), contextWith(server));
    await settled();
    expect(page.update(route(102))).toBe(true);
    expect(document.querySelectorAll('dialog')).toHaveLength(1);
    expect(document.querySelector('dialog h2')?.textContent).toContain('hit2');
    expect(page.update(route(103))).toBe(true);
    expect(document.querySelectorAll('dialog')).toHaveLength(1);
    expect(page.update(route())).toBe(true);
    expect(document.querySelector('dialog')).toBeNull();
    expect(server.similar).toHaveBeenCalledOnce();
});

it('leads from a hit to its neighbours in the list', async () => {
    page = resultsPage(route(102), contextWith(client()));
    await settled();
    const hrefOf = (label: string) =>
        document.querySelector(`dialog [aria-label="${label}"]`)?.getAttribute('href');
    expect(hrefOf('Better hit')).toBe('#/models/7/hits/101');
    expect(hrefOf('Next hit')).toBe('#/models/7/hits/103');
});

it('goes back to the hits from one that is not among them', async () => {
    const context = contextWith(client());
    page = resultsPage(route(999), context);
    await settled();
    expect(context.visited).toEqual([route()]);
});

it('searches again for other parameters, and its form follows the address', async () => {
    const server = client();
    page = resultsPage(route(), contextWith(server));
    await settled();
    expect(page.update(route(null, 0.8))).toBe(true);
    await settled();
    expect(server.similar).toHaveBeenCalledTimes(2);
    expect(page.node.querySelector<HTMLInputElement>('[name=pose]')?.value).toBe('0.8');
    expect(page.update(resultsOf({ kind: 'model', id: 8 }))).toBe(false);
});

it('says that an upload is gone after the page was loaded anew', async () => {
    page = resultsPage(resultsOf({ kind: 'upload' }) as ResultsRoute, contextWith({}));
    await settled();
    expect(page.node.textContent).toContain('The uploaded model is gone');
});

it('shows the answer of an upload at once, and uploads again for other parameters', async () => {
    const search = vi.fn(async () => searchResult([hit(1)]));
    const context = contextWith({ search });
    const file = new File(['OFF'], 'a.off');
    context.upload = { file, parameters: kSearchDefaults, result: searchResult() };
    page = resultsPage(resultsOf({ kind: 'upload' }) as ResultsRoute, context);
    await settled();
    expect(search).not.toHaveBeenCalled();
    expect(page.node.querySelectorAll('.hit-card')).toHaveLength(2);
    page.update(resultsOf({ kind: 'upload' }, { ...kSearchDefaults, ranker: 'skeleton' }));
    await settled();
    expect(search).toHaveBeenCalledOnce();
    expect(page.node.querySelectorAll('.hit-card')).toHaveLength(1);
});

it('shows a problem and tries again on demand', async () => {
    const server = client();
    server.similar.mockRejectedValueOnce(unreachable());
    page = resultsPage(route(), contextWith(server));
    await settled();
    expect(page.node.querySelector('.notice-code')?.textContent).toBe('unreachable');
    page.node.querySelector<HTMLButtonElement>('.notice button')?.click();
    await settled();
    expect(page.node.querySelectorAll('.hit-card')).toHaveLength(3);
});
