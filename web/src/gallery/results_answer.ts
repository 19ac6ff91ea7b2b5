import type { HeldModel } from '../api/client';
import { kUsualUp, type QueryModel } from '../api/elements';
import { ApiError } from '../api/problem';
import { kSearchDefaults, type SearchParameters } from '../api/search_parameters';
import type { Hit, SearchResult } from '../api/types';
import type { Answer, Context } from '../page/context';
import { formatRoute, type Over, type Route, resultsOf } from '../page/routes';
import type { Upload } from '../page/uploads';
import type { LikeHit } from './build_and_pose';

export type ResultsRoute = Extract<Route, { page: 'results' }>;

export function sameParameters(a: SearchParameters, b: SearchParameters): boolean {
    return (Object.keys(a) as (keyof SearchParameters)[]).every((name) => a[name] === b[name]);
}

/** Whether the server answers both alike, in whatever order the page shows it. */
export function sameQuestion(a: SearchParameters, b: SearchParameters): boolean {
    return sameParameters({ ...a, order: b.order }, b);
}

/** The results without what lies over them. */
export function under({ query, parameters }: ResultsRoute): Route {
    return resultsOf(query, parameters);
}

export function overWith({ query, parameters }: ResultsRoute, over: Over): Route {
    return resultsOf(query, parameters, over);
}

/** Where the comparison with a hit is. */
export function hrefOf(route: ResultsRoute, hit: Hit): string {
    return formatRoute(overWith(route, { kind: 'hit', id: hit.id }));
}

/** Where the searches by a hit's build alone and by its pose alone are. */
export function likeHit({ parameters }: ResultsRoute, hit: Hit): LikeHit {
    const at = (pose: number): string =>
        formatRoute(resultsOf({ kind: 'model', id: hit.id }, { ...parameters, pose, part: false }));
    return { build: at(0), pose: at(1) };
}

/** What the server holds of the query; null: nothing. */
export function heldModel({ query }: ResultsRoute): HeldModel | null {
    return query.kind === 'upload' ? null : query;
}

function answerOf(result: SearchResult): Answer {
    const { mesh, up = kUsualUp }: QueryModel = result.query;
    return { result, mesh: mesh ?? null, up };
}

async function askUpload(
    upload: Upload | undefined,
    route: ResultsRoute,
    context: Context,
    signal: AbortSignal,
): Promise<Answer | null> {
    if (!upload) {
        return null;
    }
    const { answer } = upload;
    const result =
        answer && sameQuestion(answer.parameters, route.parameters)
            ? answer.result
            : await context.uploads.again(upload, route.parameters, signal);
    return result && answerOf(result);
}

async function askHeld(
    query: HeldModel,
    parameters: SearchParameters,
    { client }: Context,
    signal: AbortSignal,
): Promise<Answer> {
    const [result, mesh, up] = await Promise.all([
        client.similar(query, parameters, signal),
        client.mesh(query, signal),
        query.kind === 'model' ? client.model(query.id, signal).then((model) => model.up) : null,
    ]);
    return { result, mesh, up: up ?? (result.query as QueryModel).up ?? kUsualUp };
}

/** An upload that the server has forgotten is sent again while this page has its bytes. */
async function askKept(
    query: HeldModel & { kind: 'query' },
    route: ResultsRoute,
    context: Context,
    signal: AbortSignal,
): Promise<Answer | null> {
    const upload = context.uploads.find(query.token);
    if (upload?.answer && sameQuestion(upload.answer.parameters, route.parameters)) {
        return answerOf(upload.answer.result);
    }
    try {
        return await askHeld(query, route.parameters, context, signal);
    } catch (error) {
        if (!(error instanceof ApiError && error.code === 'query_not_found')) {
            throw error;
        }
        const result = upload && (await context.uploads.again(upload, route.parameters, signal));
        return result ? answerOf(result) : null;
    }
}

/** Null: the upload is gone, here and on the server. */
export async function ask(
    route: ResultsRoute,
    context: Context,
    signal: AbortSignal,
): Promise<Answer | null> {
    const { query, parameters } = route;
    if (query.kind === 'upload') {
        // One address for all of them.
        return askUpload(context.uploads.unkept, route, context, signal);
    }
    const { order } = kSearchDefaults;
    const address = formatRoute(resultsOf(query, { ...parameters, order }));
    const known = context.answers.get(address);
    if (known) {
        return known;
    }
    const answer =
        query.kind === 'query'
            ? await askKept(query, route, context, signal)
            : await askHeld(query, parameters, context, signal);
    if (answer) {
        context.answers.set(address, answer);
    }
    return answer;
}
