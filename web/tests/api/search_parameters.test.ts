import { describe, expect, it } from 'vitest';

import { kRankers } from '../../src/api/elements';
import {
    decodeSearch,
    encodeSearch,
    encodeSearchBriefly,
    kHitOrders,
    kLimits,
    kSearchDefaults,
    type SearchParameters,
} from '../../src/api/search_parameters';

function* variants(): Generator<SearchParameters> {
    for (const ranker of kRankers) {
        for (const pose of [0, 0.15, 0.35, 1]) {
            for (const rerank of [false, true]) {
                for (const className of ['', 'human', 'a & b=c#d/ü']) {
                    const size = rerank ? 1 : 0;
                    const rest = { part: !rerank, fold: pose < 0.5, limit: 48, className };
                    const where = { folder: className, kind: rerank ? 'stl' : '' };
                    const order = kHitOrders[pose < 0.5 ? 0 : 2] ?? 'distance';
                    yield { ranker, pose, size, rerank, ...rest, ...where, order };
                }
            }
        }
    }
}

describe('search parameters', () => {
    it('survive being encoded, in full and briefly', () => {
        for (const parameters of variants()) {
            const brief = encodeSearchBriefly(parameters).toString();
            expect(decodeSearch(new URLSearchParams(brief))).toEqual(parameters);
            // The server is not told in which order the page shows its hits.
            const full = encodeSearch(parameters);
            expect(full.has('sort')).toBe(false);
            const { order } = kSearchDefaults;
            expect(decodeSearch(full)).toEqual({ ...parameters, order });
        }
    });

    it('ask for no re-ranking of parts, which the server would refuse', () => {
        const query = encodeSearch({ ...kSearchDefaults, rerank: true, part: true });
        expect(query.get('rerank')).toBe('false');
        expect(query.get('part')).toBe('true');
    });

    it('leave nothing in the address where all are defaults', () => {
        expect(encodeSearchBriefly(kSearchDefaults).size).toBe(0);
        expect(encodeSearch(kSearchDefaults).get('ranker')).toBe('hybrid');
    });

    it('send no empty class, which the server would refuse', () => {
        expect(encodeSearch(kSearchDefaults).has('class')).toBe(false);
    });

    it.each([
        'ranker=fastest',
        'ranker=',
        'pose=abc',
        'pose=',
        'pose=NaN',
        'limit=0',
        'limit=-3',
        'limit=2.5',
        'limit=1e9',
        'rerank=perhaps',
        'size=large',
        'unknown=1',
    ])('become the defaults where the address makes no sense: %s', (address) => {
        expect(decodeSearch(new URLSearchParams(address))).toEqual(kSearchDefaults);
    });

    it('hold the pose between 0 and 1', () => {
        expect(decodeSearch(new URLSearchParams('pose=7')).pose).toBe(1);
        expect(decodeSearch(new URLSearchParams('pose=-1')).pose).toBe(0);
    });

    it('offer only limits that the server takes', () => {
        expect(kLimits).toContain(kSearchDefaults.limit);
        for (const limit of kLimits) {
            expect(decodeSearch(new URLSearchParams({ limit: String(limit) })).limit).toBe(limit);
        }
    });
});
