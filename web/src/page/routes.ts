import {
    decodeFilter,
    encodeFilter,
    type HeldModel,
    kAllModels,
    kModelOrders,
    type ModelFilter,
    type ModelOrder,
} from '../api/client';
import {
    decodeSearch,
    encodeSearchBriefly,
    kSearchDefaults,
    type SearchParameters,
} from '../api/search_parameters';

/**
 * What the page shows, as its address after `#` says it:
 * `#/?name&class&folder&kind&branches&loops&extent&unit&sort&at` · `#/models/7` · `#/models/7/parts?posed` · `#/models/7/look` ·
 * `#/models/7/hits/12` ·
 * `#/q/TOKEN` and `#/search` likewise · `#/reports` · `#/manage`.
 */
export type Route =
    | HomeRoute
    | { page: 'results'; query: QuerySource; parameters: SearchParameters; over: Over }
    | { page: 'reports' }
    | { page: 'manage' }
    | { page: 'missing'; path: string };

export interface HomeRoute {
    page: 'home';
    filter: ModelFilter;
    sort: ModelOrder;
    /** The first model in sight, from 0. */
    at: number;
}

/**
 * What lies over the results: the comparison with a hit, a closer look at the query or its parts, or
 * nothing.
 */
export type Over =
    | { kind: 'hit'; id: number }
    | { kind: 'look' }
    | { kind: 'parts'; posed: string }
    | null;

/** What the server holds, or the last upload of a server that keeps none (then the page does). */
export type QuerySource = HeldModel | { kind: 'upload' };

export const kHome: HomeRoute = { page: 'home', filter: kAllModels, sort: 'name', at: 0 };

function parseId(text: string): number | null {
    const id = /^[0-9]{1,15}$/.test(text) ? Number(text) : Number.NaN;
    return Number.isSafeInteger(id) ? id : null;
}

function parseOver(segments: string[], source: QuerySource, query: URLSearchParams): Over {
    if (segments[0] === 'parts' && segments.length === 1 && source.kind !== 'upload') {
        return { kind: 'parts', posed: query.get('posed') ?? '' };
    }
    if (segments[0] === 'look' && segments.length === 1) {
        return { kind: 'look' };
    }
    const id = segments[0] === 'hits' && segments.length === 2 ? parseId(segments[1] ?? '') : null;
    return id === null ? null : { kind: 'hit', id };
}

function parseSource([kind, name = '']: string[]): QuerySource | null {
    if (kind === 'search') {
        return { kind: 'upload' };
    }
    if (kind === 'q') {
        return /^[0-9a-f]{32}$/.test(name) ? { kind: 'query', token: name } : null;
    }
    const id = kind === 'models' ? parseId(name) : null;
    return id === null ? null : { kind: 'model', id };
}

function parseHome(query: URLSearchParams): HomeRoute {
    return {
        page: 'home',
        filter: decodeFilter(query),
        sort: kModelOrders.find((order) => order === query.get('sort')) ?? kHome.sort,
        at: parseId(query.get('at') ?? '') ?? 0,
    };
}

function parseResults(segments: string[], query: URLSearchParams): Route | null {
    const source = parseSource(segments);
    if (source === null) {
        return null;
    }
    const rest = segments.slice(source.kind === 'upload' ? 1 : 2);
    const over = parseOver(rest, source, query);
    if (rest.length > 0 && over === null) {
        return null;
    }
    return { page: 'results', query: source, parameters: decodeSearch(query), over };
}

/** Takes whatever stands in the address bar. */
export function parseRoute(hash: string): Route {
    const address = hash.replace(/^#/, '');
    const mark = address.indexOf('?');
    const path = mark < 0 ? address : address.slice(0, mark);
    const query = new URLSearchParams(mark < 0 ? '' : address.slice(mark + 1));
    const segments = path.split('/').filter((segment) => segment !== '');
    if (segments.length === 0) {
        return parseHome(query);
    }
    if (segments.length === 1 && segments[0] === 'reports') {
        return { page: 'reports' };
    }
    if (segments.length === 1 && segments[0] === 'manage') {
        return { page: 'manage' };
    }
    return parseResults(segments, query) ?? { page: 'missing', path };
}

function withQuery(path: string, query: URLSearchParams): string {
    return query.size > 0 ? `#${path}?${query}` : `#${path}`;
}

function formatSource(source: QuerySource): string {
    switch (source.kind) {
        case 'model':
            return `/models/${source.id}`;
        case 'query':
            return `/q/${source.token}`;
        case 'upload':
            return '/search';
    }
}

function formatOver(over: Over): string {
    if (over === null) {
        return '';
    }
    return over.kind === 'hit' ? `/hits/${over.id}` : `/${over.kind}`;
}

/** The inverse of {@link parseRoute}. */
export function formatRoute(route: Route): string {
    switch (route.page) {
        case 'home': {
            const query = encodeFilter(route.filter);
            if (route.sort !== kHome.sort) {
                query.set('sort', route.sort);
            }
            if (route.at > 0) {
                query.set('at', String(route.at));
            }
            return withQuery('/', query);
        }
        case 'results': {
            const query = encodeSearchBriefly(route.parameters);
            if (route.over?.kind === 'parts' && route.over.posed !== '') {
                query.set('posed', route.over.posed);
            }
            return withQuery(formatSource(route.query) + formatOver(route.over), query);
        }
        case 'reports':
            return '#/reports';
        case 'manage':
            return '#/manage';
        case 'missing':
            return `#${route.path}`;
    }
}

export function resultsOf(
    query: QuerySource,
    parameters: SearchParameters = kSearchDefaults,
    over: Over = null,
): Route {
    return { page: 'results', query, parameters, over };
}

export function sameQuery(a: QuerySource, b: QuerySource): boolean {
    return formatSource(a) === formatSource(b);
}

export function lookAt(model: QuerySource, parameters: SearchParameters = kSearchDefaults): Route {
    return resultsOf(model, parameters, { kind: 'look' });
}

export function partsOf(model: HeldModel, parameters: SearchParameters = kSearchDefaults): Route {
    return resultsOf(model, parameters, { kind: 'parts', posed: '' });
}
