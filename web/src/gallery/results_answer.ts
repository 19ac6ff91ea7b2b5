import { kUsualUp, type PreviewMesh, type QueryModel, type UpAxis } from '../api/elements';
import type { SearchParameters } from '../api/search_parameters';
import type { Hit, SearchResult } from '../api/types';
import type { Context } from '../page/context';
import { formatRoute, type Route, resultsOf } from '../page/routes';
import type { LikeHit } from './build_and_pose';

export type ResultsRoute = Extract<Route, { page: 'results' }>;

/** What the server says of a query, and how to draw it. */
export interface Answer {
    result: SearchResult;
    mesh: PreviewMesh | null;
    up: UpAxis;
}

export function sameParameters(a: SearchParameters, b: SearchParameters): boolean {
    return (Object.keys(a) as (keyof SearchParameters)[]).every((name) => a[name] === b[name]);
}

/** Where the comparison with a hit is. */
export function hrefOf({ query, parameters }: ResultsRoute, hit: Hit): string {
    return formatRoute(resultsOf(query, parameters, { kind: 'hit', id: hit.id }));
}

/** Where the searches by a hit's build alone and by its pose alone are. */
export function likeHit({ parameters }: ResultsRoute, hit: Hit): LikeHit {
    const at = (pose: number): string =>
        formatRoute(resultsOf({ kind: 'model', id: hit.id }, { ...parameters, pose }));
    return { build: at(0), pose: at(1) };
}

/** Null: the upload is gone, since the page was loaded anew. */
export async function ask(
    route: ResultsRoute,
    context: Context,
    signal: AbortSignal,
): Promise<Answer | null> {
    const { query, parameters } = route;
    if (query.kind === 'model') {
        const [result, mesh, { up }] = await Promise.all([
            context.client.similar(query.id, parameters, signal),
            context.client.mesh(query.id, signal),
            context.client.model(query.id, signal),
        ]);
        return { result, mesh, up };
    }
    const { upload } = context;
    if (!upload) {
        return null;
    }
    const result = sameParameters(upload.parameters, parameters)
        ? upload.result
        : await context.client.search(upload.file, parameters, signal);
    context.upload = { file: upload.file, parameters, result };
    const { mesh, up = kUsualUp }: QueryModel = result.query;
    return { result, mesh: mesh ?? null, up };
}
