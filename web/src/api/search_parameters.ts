import { kRankers } from './elements';
import type { Ranker } from './types';

export const kHitOrders = ['distance', 'name', 'faces', 'size'] as const;
export type HitOrder = (typeof kHitOrders)[number];

/** What a search may be asked for; the same names in the page's address and in the request. */
export interface SearchParameters {
    ranker: Ranker;
    /** 0: build alone, whatever limbs do; 1: pose alone, whatever the body; between: kinds. */
    pose: number;
    /** 0: bodies of any size; 1: size counts, for models of one unit. */
    size: 0 | 1;
    rerank: boolean;
    /** Models that have the query as a part. */
    part: boolean;
    /** Copies of one model are one hit. */
    fold: boolean;
    limit: number;
    /** Empty: all classes. */
    className: string;
    /** Below the folder that was indexed; empty: all. */
    folder: string;
    /** The ending of the model's file, in small letters; empty: any. */
    kind: string;
    /** In which the page shows the hits; the server is not asked for it. */
    order: HitOrder;
}

export const kSearchDefaults: Readonly<SearchParameters> = {
    ranker: 'hybrid',
    pose: 0.15,
    size: 0,
    rerank: false,
    part: false,
    fold: true,
    limit: 24,
    className: '',
    folder: '',
    kind: '',
    order: 'distance',
};

const kMostHits = 1000;
export const kLimits: readonly number[] = [12, 24, 48, 96];

/** The number of hits after this one; null: there is none. */
export function nextLimit(limit: number): number | null {
    return limit < kMostHits ? Math.min(kMostHits, Math.max(kLimits[0] ?? 1, 2 * limit)) : null;
}

function isRanker(value: string | null): value is Ranker {
    return value !== null && (kRankers as readonly string[]).includes(value);
}

function parsePose(value: string | null): number {
    const pose = value === null || value.trim() === '' ? Number.NaN : Number(value);
    return Number.isFinite(pose) ? Math.min(1, Math.max(0, pose)) : kSearchDefaults.pose;
}

function parseLimit(value: string | null): number {
    const limit = Number(value);
    return Number.isInteger(limit) && limit >= 1 && limit <= kMostHits
        ? limit
        : kSearchDefaults.limit;
}

/** Everything spelled out: what the request carries. */
export function encodeSearch(parameters: SearchParameters): URLSearchParams {
    const query = new URLSearchParams({
        limit: String(parameters.limit),
        ranker: parameters.ranker,
        pose: String(parameters.pose),
        // A part is not ranked by what whole models have in common.
        rerank: String(parameters.rerank && !parameters.part),
        part: String(parameters.part),
        fold: String(parameters.fold),
    });
    if (parameters.size > 0) {
        query.set('size', String(parameters.size));
    }
    const { className, folder, kind } = parameters;
    for (const [name, value] of Object.entries({ class: className, folder, kind })) {
        if (value !== '') {
            query.set(name, value);
        }
    }
    return query;
}

/** What of them two models are compared by. */
export function encodeComparison(
    a: number,
    b: number,
    { ranker, pose, size, part }: SearchParameters,
): URLSearchParams {
    const query = new URLSearchParams({
        a: String(a),
        b: String(b),
        ranker,
        pose: String(pose),
        part: String(part),
    });
    if (size > 0) {
        query.set('size', String(size));
    }
    return query;
}

/** Only what differs from the defaults: what the page's address carries. */
export function encodeSearchBriefly(parameters: SearchParameters): URLSearchParams {
    const query = encodeSearch(parameters);
    for (const [name, value] of encodeSearch(kSearchDefaults)) {
        if (query.get(name) === value) {
            query.delete(name);
        }
    }
    if (parameters.order !== kSearchDefaults.order) {
        query.set('sort', parameters.order);
    }
    return query;
}

/** Takes any address: what is missing or makes no sense becomes the default. */
export function decodeSearch(query: URLSearchParams): SearchParameters {
    const ranker = query.get('ranker');
    return {
        ranker: isRanker(ranker) ? ranker : kSearchDefaults.ranker,
        pose: parsePose(query.get('pose')),
        size: query.get('size') === '1' ? 1 : 0,
        rerank: query.get('rerank') === 'true',
        part: query.get('part') === 'true',
        fold: query.get('fold') !== 'false',
        limit: parseLimit(query.get('limit')),
        className: query.get('class') ?? '',
        folder: query.get('folder') ?? '',
        kind: query.get('kind') ?? '',
        order: kHitOrders.find((order) => order === query.get('sort')) ?? kSearchDefaults.order,
    };
}
