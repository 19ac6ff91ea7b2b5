import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import type { Client } from '../../src/api/client';
import { ApiError, unreachable } from '../../src/api/problem';
import { kSearchDefaults } from '../../src/api/search_parameters';
import type { Comparison } from '../../src/api/types';
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

const kToken = '0123456789abcdef'.repeat(2);

beforeEach(() => sessionStorage.clear());

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

it('shows the hits in another order without asking again, and steps through them in it', async () => {
    const server = client();
    server.similar.mockResolvedValue(
        searchResult([hit(1, { name: 'b' }), hit(2, { name: 'c' }), hit(3, { name: 'a' })]),
    );
    const context = contextWith(server);
    page = resultsPage(route(), context);
    await settled();
    const select = page.node.querySelector<HTMLSelectElement>('.hit-order select');
    if (select) {
        select.value = 'name';
        select.dispatchEvent(new Event('change'));
    }
    const named = resultsOf(kModel, { ...kSearchDefaults, order: 'name' }) as ResultsRoute;
    expect(context.visited).toEqual([named]);
    expect(page.update(named)).toBe(true);
    const names = [...page.node.querySelectorAll('.hit-card .card-name')];
    expect(names.map((name) => name.textContent)).toEqual(['a', 'b', 'c']);
    expect(page.update({ ...named, over: { kind: 'hit', id: 101 } })).toBe(true);
    document.querySelector<HTMLButtonElement>('dialog [aria-label="Next hit"]')?.click();
    expect(context.visited.at(-1)).toEqual({ ...named, over: { kind: 'hit', id: 102 } });
    expect(server.similar).toHaveBeenCalledOnce();
});

it('leads from a hit to its neighbours in the list', async () => {
    const context = contextWith(client());
    page = resultsPage(route(102), context);
    await settled();
    for (const label of ['Better hit', 'Next hit']) {
        document.querySelector<HTMLButtonElement>(`dialog [aria-label="${label}"]`)?.click();
    }
    expect(context.visited).toEqual([route(101), route(103)]);
    expect(context.titles.at(-1)).toBe('elephant ↔ hit2');
});

it('compares any two models of the collection, also those that are no hits of each other', async () => {
    const { match, parts } = hit(1);
    const found: Comparison = {
        a: model(7),
        b: model(999, { name: 'far away' }),
        ranker: 'hybrid',
        distance: 1.5,
        part: false,
        parts,
        build_difference: 1,
        pose_difference: 1,
        matched_nodes: 2,
        match,
        skeletons: { a: kSkeleton, b: kSkeleton },
    };
    const compare = vi.fn(async () => found);
    page = resultsPage(route(999), contextWith({ ...client(), compare }));
    await settled();
    expect(compare).toHaveBeenCalledOnce();
    expect(document.querySelector('dialog h2')?.textContent).toContain('far away');
    expect(document.querySelector('#next-hit')?.getAttribute('aria-disabled')).toBe('true');
});

it('asks for more hits in place of these, as long as there may be more', async () => {
    const context = contextWith(client());
    page = resultsPage({ ...route(), parameters: { ...kSearchDefaults, limit: 3 } }, context);
    await settled();
    page.node.querySelector<HTMLButtonElement>('.more-hits')?.click();
    expect(context.visited).toEqual([
        { ...route(), parameters: { ...kSearchDefaults, limit: 12 } },
    ]);
    page.dispose();
    page = resultsPage({ ...route(), parameters: { ...kSearchDefaults, limit: 4 } }, context);
    await settled();
    expect(page.node.querySelector('.more-hits')).toBeNull();
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

describe('an upload', () => {
    const kOther = { ...kSearchDefaults, ranker: 'skeleton' } as const;

    async function uploaded(token: string | null, methods: Partial<Client> = {}) {
        const search = vi.fn(async () => ({ ...searchResult(), token }));
        const context = contextWith({ search, ...methods });
        context.uploads.take([new File(['OFF'], 'a.off')], kSearchDefaults);
        await settled();
        return { search, context };
    }

    it('that the server keeps is sent once, whatever it is asked for', async () => {
        const similar = vi.fn(async () => ({ ...searchResult([hit(1)]), token: kToken }));
        const { search, context } = await uploaded(kToken, { similar, mesh: async () => kMesh });
        const query = { kind: 'query', token: kToken } as const;
        page = resultsPage(resultsOf(query) as ResultsRoute, context);
        await settled();
        expect(page.node.querySelectorAll('.hit-card')).toHaveLength(2);
        expect(similar).not.toHaveBeenCalled();
        page.update(resultsOf(query, kOther));
        await settled();
        expect(page.node.querySelectorAll('.hit-card')).toHaveLength(1);
        expect(search).toHaveBeenCalledOnce();
        expect(page.node.querySelector('.query-text a[href*=parts]')?.getAttribute('href')).toBe(
            `#/q/${kToken}/parts`,
        );
    });

    it('is sent again where the server has forgotten it, under its new token', async () => {
        const forgotten = new ApiError({
            title: 'The query is gone',
            status: 404,
            detail: '',
            code: 'query_not_found',
        });
        const similar = vi.fn(() => Promise.reject(forgotten));
        const { search, context } = await uploaded(kToken, { similar, mesh: async () => kMesh });
        const renewed = 'f'.repeat(32);
        search.mockResolvedValueOnce({ ...searchResult([hit(1)]), token: renewed });
        page = resultsPage(
            resultsOf({ kind: 'query', token: kToken }, kOther) as ResultsRoute,
            context,
        );
        await settled();
        expect(page.node.querySelectorAll('.hit-card')).toHaveLength(1);
        expect(context.visited).toEqual([resultsOf({ kind: 'query', token: renewed }, kOther)]);
    });

    it('that the server does not keep is sent again for other parameters', async () => {
        const { search, context } = await uploaded(null);
        page = resultsPage(resultsOf({ kind: 'upload' }) as ResultsRoute, context);
        await settled();
        expect(search).toHaveBeenCalledOnce();
        expect(page.node.querySelectorAll('.hit-card')).toHaveLength(2);
        search.mockResolvedValueOnce({ ...searchResult([hit(1)]), token: null });
        page.update(resultsOf({ kind: 'upload' }, kOther));
        await settled();
        expect(search).toHaveBeenCalledTimes(2);
        expect(page.node.querySelectorAll('.hit-card')).toHaveLength(1);
    });
});

it('keeps an answer for the way back', async () => {
    const server = client();
    const context = contextWith(server);
    resultsPage(route(), context);
    await settled();
    page = resultsPage(route(), context);
    await settled();
    expect(server.similar).toHaveBeenCalledOnce();
    expect(page.node.querySelectorAll('.hit-card')).toHaveLength(3);
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
