import {
    decodeSearch,
    encodeSearchBriefly,
    kSearchDefaults,
    type SearchParameters,
} from '../api/search_parameters';

/**
 * What the page shows, as its address after `#` says it:
 * `#/?name&class` · `#/search` · `#/models/7` · `#/models/7/hits/12` · `#/search/hits/12` ·
 * `#/reports`.
 */
export type Route =
    | { page: 'home'; name: string; className: string }
    | { page: 'results'; query: QuerySource; parameters: SearchParameters; hit: number | null }
    | { page: 'reports' }
    | { page: 'missing'; path: string };

/** A model of the collection by its id, or the file that was uploaded last (kept in memory). */
export type QuerySource = { kind: 'model'; id: number } | { kind: 'upload' };

export const kHome: Route = { page: 'home', name: '', className: '' };

function parseId(text: string): number | null {
    const id = /^[0-9]{1,15}$/.test(text) ? Number(text) : Number.NaN;
    return Number.isSafeInteger(id) ? id : null;
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
    const hit = rest[0] === 'hits' && rest.length === 2 ? parseId(rest[1] ?? '') : null;
    if (rest.length > 0 && hit === null) {
        return null;
    }
    return { page: 'results', query: source, parameters: decodeSearch(query), hit };
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
            const path = route.hit === null ? base : `${base}/hits/${route.hit}`;
            return withQuery(path, encodeSearchBriefly(route.parameters));
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
    hit: number | null = null,
): Route {
    return { page: 'results', query, parameters, hit };
}

export function sameQuery(a: QuerySource, b: QuerySource): boolean {
    return a.kind === 'model' && b.kind === 'model' ? a.id === b.id : a.kind === b.kind;
}
