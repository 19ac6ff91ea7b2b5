import {
    decodeSearch,
    encodeSearchBriefly,
    kSearchDefaults,
    type SearchParameters,
} from '../api/search_parameters';

/**
 * What the page shows, as its address after `#` says it:
 * `#/?name&class` · `#/search` · `#/models/7` · `#/models/7/parts` · `#/models/7/hits/12` ·
 * `#/search/hits/12` · `#/reports`.
 */
export type Route =
    | { page: 'home'; name: string; className: string }
    | { page: 'results'; query: QuerySource; parameters: SearchParameters; over: Over }
    | { page: 'reports' }
    | { page: 'missing'; path: string };

/** What lies over the results: the comparison with a hit, the parts of the query, or nothing. */
export type Over = { kind: 'hit'; id: number } | { kind: 'parts' } | null;

/** A model of the collection by its id, or the file that was uploaded last (kept in memory). */
export type QuerySource = { kind: 'model'; id: number } | { kind: 'upload' };

export const kHome: Route = { page: 'home', name: '', className: '' };

function parseId(text: string): number | null {
    const id = /^[0-9]{1,15}$/.test(text) ? Number(text) : Number.NaN;
    return Number.isSafeInteger(id) ? id : null;
}

function parseOver(segments: string[], source: QuerySource): Over {
    if (segments[0] === 'parts' && segments.length === 1 && source.kind === 'model') {
        return { kind: 'parts' };
    }
    const id = segments[0] === 'hits' && segments.length === 2 ? parseId(segments[1] ?? '') : null;
    return id === null ? null : { kind: 'hit', id };
}

function parseResults(segments: string[], query: URLSearchParams): Route | null {
    let source: QuerySource;
    let rest: string[];
    if (segments[0] === 'search') {
        source = { kind: 'upload' };
        rest = segments.slice(1);
    } else {
        const id = parseId(segments[1] ?? '');
        if (segments[0] !== 'models' || id === null) {
            return null;
        }
        source = { kind: 'model', id };
        rest = segments.slice(2);
    }
    const over = parseOver(rest, source);
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
        return {
            page: 'home',
            name: query.get('name') ?? '',
            className: query.get('class') ?? '',
        };
    }
    if (segments.length === 1 && segments[0] === 'reports') {
        return { page: 'reports' };
    }
    return parseResults(segments, query) ?? { page: 'missing', path };
}

function withQuery(path: string, query: URLSearchParams): string {
    return query.size > 0 ? `#${path}?${query}` : `#${path}`;
}

function formatOver(over: Over): string {
    if (over === null) {
        return '';
    }
    return over.kind === 'parts' ? '/parts' : `/hits/${over.id}`;
}

/** The inverse of {@link parseRoute}. */
export function formatRoute(route: Route): string {
    switch (route.page) {
        case 'home': {
            const query = new URLSearchParams();
            if (route.name !== '') {
                query.set('name', route.name);
            }
            if (route.className !== '') {
                query.set('class', route.className);
            }
            return withQuery('/', query);
        }
        case 'results': {
            const base = route.query.kind === 'upload' ? '/search' : `/models/${route.query.id}`;
            return withQuery(base + formatOver(route.over), encodeSearchBriefly(route.parameters));
        }
        case 'reports':
            return '#/reports';
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
    return a.kind === 'model' && b.kind === 'model' ? a.id === b.id : a.kind === b.kind;
}

export function partsOf(id: number, parameters: SearchParameters = kSearchDefaults): Route {
    return resultsOf({ kind: 'model', id }, parameters, { kind: 'parts' });
}
