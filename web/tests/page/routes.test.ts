import { describe, expect, it } from 'vitest';

import { kAllModels } from '../../src/api/client';
import { kSearchDefaults } from '../../src/api/search_parameters';
import {
    formatRoute,
    kHome,
    parseRoute,
    partsOf,
    type QuerySource,
    type Route,
    resultsOf,
    sameQuery,
} from '../../src/page/routes';

const kSeven = { kind: 'model', id: 7 } as const;
const kQuery = { kind: 'query', token: '0123456789abcdef'.repeat(2) } as const;

function* routes(): Generator<Route> {
    yield kHome;
    yield {
        page: 'home',
        filter: {
            ...kAllModels,
            name: 'a b&c',
            className: 'four/legs #1?',
            folder: 'x/ü',
            kind: 'stl',
            branches: '5-8',
            loops: '17-',
            extent: '10-100mm',
            unit: '0.3 m',
        },
        sort: 'faces',
        at: 120,
    };
    yield { page: 'reports' };
    yield partsOf(kSeven);
    yield partsOf(kQuery);
    yield resultsOf(kSeven, kSearchDefaults, { kind: 'parts', posed: '1.20.-30.500~2.0.0.1' });
    const sources: QuerySource[] = [{ kind: 'upload' }, kSeven, kQuery];
    for (const source of sources) {
        for (const over of [null, { kind: 'hit', id: 12 } as const]) {
            yield resultsOf(source, kSearchDefaults, over);
            yield resultsOf(
                source,
                {
                    ranker: 'chain-code',
                    pose: 0.5,
                    size: 1,
                    rerank: true,
                    part: false,
                    fold: false,
                    limit: 96,
                    className: 'ü &=',
                    folder: '',
                    kind: '',
                    order: 'faces',
                },
                over,
            );
        }
    }
}

describe('routes', () => {
    it('survive the address bar', () => {
        for (const route of routes()) {
            expect(parseRoute(formatRoute(route))).toEqual(route);
            // Browsers may hand the address over with its escapes as a URL has them.
            const address = new URL(formatRoute(route), 'http://server/');
            expect(parseRoute(address.hash)).toEqual(route);
        }
    });

    it('are told apart by their addresses', () => {
        const addresses = [...routes()].map(formatRoute);
        expect(new Set(addresses).size).toBe(addresses.length);
    });

    it('take only a place and an order that make sense', () => {
        expect(parseRoute('#/?at=-3&sort=beauty')).toEqual(kHome);
    });

    it.each(['', '#', '#/', '/'])('take %j for the start page', (hash) => {
        expect(parseRoute(hash)).toEqual(kHome);
    });

    it('have the documented addresses', () => {
        expect(formatRoute(resultsOf({ kind: 'model', id: 7 }))).toBe('#/models/7');
        expect(
            formatRoute(resultsOf({ kind: 'upload' }, kSearchDefaults, { kind: 'hit', id: 12 })),
        ).toBe('#/search/hits/12');
        expect(formatRoute(partsOf(kSeven))).toBe('#/models/7/parts');
        expect(formatRoute(partsOf(kQuery))).toBe(`#/q/${kQuery.token}/parts`);
        expect(parseRoute('#/reports')).toEqual({ page: 'reports' });
    });

    it.each([
        '#/models',
        '#/models/x',
        '#/models/-1',
        '#/models/1.5',
        '#/models/99999999999999999999',
        '#/models/7/hits',
        '#/models/7/parts/3',
        '#/search/parts',
        '#/q',
        '#/q/xyz',
        `#/q/${'A'.repeat(32)}`,
        '#/models/7/hits/x',
        '#/models/7/hits/3/4',
        '#/models/7/other/3',
        '#/nothing',
        '#/reports/deep',
        '#/%E0%A4%A',
    ])('say that %s is no page', (hash) => {
        expect(parseRoute(hash).page).toBe('missing');
    });
});

describe('sameQuery', () => {
    it('compares the kind and the id', () => {
        const seven: QuerySource = { kind: 'model', id: 7 };
        expect(sameQuery(seven, { kind: 'model', id: 7 })).toBe(true);
        expect(sameQuery(seven, { kind: 'model', id: 8 })).toBe(false);
        expect(sameQuery(seven, { kind: 'upload' })).toBe(false);
        expect(sameQuery({ kind: 'upload' }, { kind: 'upload' })).toBe(true);
        expect(sameQuery(kQuery, { ...kQuery })).toBe(true);
        expect(sameQuery(kQuery, { kind: 'query', token: '0'.repeat(32) })).toBe(false);
    });
});
