import type { ModelSummary, PreviewMesh } from './elements';
import { ApiError, isAbort, problemFrom, unreachable } from './problem';
import { encodeComparison, encodeSearch, type SearchParameters } from './search_parameters';
import { type SentForm, sendForm } from './send_form';
import type {
    Comparison,
    Evaluation,
    Facets,
    ModelPage,
    Progress,
    QueryMetrics,
    Ranker,
    SearchResult,
    Segments,
    Skeleton,
} from './types';
import { kRoot } from './root';

export interface ClientOptions {
    /** Before every path; empty: the page's own origin. */
    base: string;
    fetch: typeof fetch;
    /** How files are sent. */
    send: (form: SentForm) => Promise<Response>;
}

const kDefaults: ClientOptions = {
    base: '',
    fetch: (input, init) => globalThis.fetch(input, init),
    send: sendForm,
};

export const kModelOrders = ['name', 'newest', 'faces', 'branches'] as const;
export type ModelOrder = (typeof kModelOrders)[number];

/** Which models of the collection; empty: all. */
export interface ModelFilter {
    name: string;
    className: string;
    /** Below the folder that was indexed. */
    folder: string;
    /** The ending of the model's file, in small letters. */
    kind: string;
    /** Ranges of numbers, by the server's names for them: `5-8`. */
    branches: string;
    loops: string;
    /** The longest side: `10-100mm`; `10-100` where the file names no unit. */
    extent: string;
    unit: string;
}

export type NumberFilter = Pick<ModelFilter, 'branches' | 'loops' | 'extent' | 'unit'>;

export const kAllModels: Readonly<ModelFilter> = {
    name: '',
    className: '',
    folder: '',
    kind: '',
    branches: '',
    loops: '',
    extent: '',
    unit: '',
};

/** A stretch of a list of models. */
export interface Stretch {
    sort: ModelOrder;
    offset: number;
    limit: number;
}

/** A model that the server holds: one of the collection, or an upload that it keeps for a while. */
export type HeldModel = { kind: 'model'; id: number } | { kind: 'query'; token: string };

export interface Client {
    /** The answer holds the query's preview mesh, so that it can be drawn at once. */
    search(
        file: File,
        parameters: SearchParameters,
        signal?: AbortSignal,
        /** Told the share of the file that is on its way. */
        onSent?: (share: number) => void,
        /** Under which its stage can be asked for: 32 random hexadecimal digits. */
        progress?: string,
    ): Promise<SearchResult>;
    progress(token: string, signal?: AbortSignal): Promise<Progress>;
    similar(
        model: HeldModel,
        parameters: SearchParameters,
        signal?: AbortSignal,
    ): Promise<SearchResult>;
    /** The distance of two models of the collection, and what matches what. */
    compare(
        a: number,
        b: number,
        parameters: SearchParameters,
        signal?: AbortSignal,
    ): Promise<Comparison>;
    models(filter: ModelFilter, stretch: Stretch, signal?: AbortSignal): Promise<ModelPage>;
    /** With loops, which a server of many models counts more slowly than all else. */
    facets(filter: ModelFilter, signal?: AbortSignal, withLoops?: boolean): Promise<Facets>;
    model(id: number, signal?: AbortSignal): Promise<ModelSummary>;
    mesh(model: HeldModel, signal?: AbortSignal): Promise<PreviewMesh>;
    skeleton(model: HeldModel, signal?: AbortSignal): Promise<Skeleton>;
    segments(model: HeldModel, signal?: AbortSignal): Promise<Segments>;
    /** The preview mesh as binary glTF, a primitive for each part, skinned by the skeleton. */
    rig(model: HeldModel, signal?: AbortSignal): Promise<ArrayBuffer>;
    evaluation(ranker: Ranker, signal?: AbortSignal): Promise<Evaluation>;
    /** The measures of each query of it. */
    evaluatedQueries(ranker: Ranker, signal?: AbortSignal): Promise<QueryMetrics[]>;
}

/** Where the server has what it holds of a model. */
export function pathOf(model: HeldModel): string {
    return model.kind === 'model'
        ? `${kRoot}/v1/models/${model.id}`
        : `${kRoot}/v1/queries/${model.token}`;
}

export function evaluationPath(ranker: Ranker, form: '' | '.csv' | '.svg' = ''): string {
    return `${kRoot}/v1/evaluations/${ranker}${form}`;
}

const kFilterNames = Object.keys(kAllModels) as (keyof ModelFilter)[];
const sentAs = (name: keyof ModelFilter): string => (name === 'className' ? 'class' : name);

/** Only what is asked for; the same names in the page's address and in the request. */
export function encodeFilter(filter: ModelFilter): URLSearchParams {
    const query = new URLSearchParams();
    for (const name of kFilterNames) {
        if (filter[name] !== '') {
            query.set(sentAs(name), filter[name]);
        }
    }
    return query;
}

export function decodeFilter(query: URLSearchParams): ModelFilter {
    const filter = { ...kAllModels };
    for (const name of kFilterNames) {
        filter[name] = query.get(sentAs(name)) ?? '';
    }
    return filter;
}

function encodeList(filter: ModelFilter, { sort, offset, limit }: Stretch): URLSearchParams {
    const query = encodeFilter(filter);
    query.set('sort', sort);
    query.set('offset', String(offset));
    query.set('limit', String(limit));
    return query;
}

async function bodyOf(response: Response): Promise<unknown> {
    try {
        return await response.json();
    } catch (error) {
        if (isAbort(error)) {
            throw error;
        }
        return undefined;
    }
}

/** Every failure but an abort is an {@link ApiError}. */
export function createClient(options: Partial<ClientOptions> = {}): Client {
    const { base, fetch, send: sendFile } = { ...kDefaults, ...options };

    async function send(path: string, type: string, init: RequestInit): Promise<Response> {
        try {
            return await fetch(base + path, {
                ...init,
                headers: { Accept: `${type}, application/problem+json` },
            });
        } catch (error) {
            throw isAbort(error) ? error : unreachable();
        }
    }

    function refusal(response: Response, body: unknown): ApiError {
        const requestId = response.headers.get('X-Request-Id') ?? undefined;
        return new ApiError(problemFrom(response.status, body, requestId));
    }

    async function request<T>(path: string, init: RequestInit): Promise<T> {
        return answered(await send(path, 'application/json', init));
    }

    async function answered<T>(response: Response): Promise<T> {
        const body = await bodyOf(response);
        if (!response.ok || typeof body !== 'object' || body === null) {
            throw refusal(response, body);
        }
        return body as T;
    }

    async function file(path: string, type: string, init: RequestInit): Promise<ArrayBuffer> {
        const response = await send(path, type, init);
        if (!response.ok) {
            throw refusal(response, await bodyOf(response));
        }
        try {
            return await response.arrayBuffer();
        } catch (error) {
            throw isAbort(error) ? error : unreachable();
        }
    }

    function get<T>(path: string, signal: AbortSignal | undefined): Promise<T> {
        return request<T>(path, signal ? { signal } : {});
    }

    return {
        async search(file, parameters, signal, onSent = () => {}, progress) {
            const query = encodeSearch(parameters);
            query.set('include', 'mesh');
            if (progress) {
                query.set('progress', progress);
            }
            const body = new FormData();
            body.append('model', file, file.name);
            const response = await sendFile({
                path: `${base}${kRoot}/v1/search?${query}`,
                headers: { Accept: 'application/json, application/problem+json' },
                body,
                onSent,
                ...(signal ? { signal } : {}),
            });
            return answered<SearchResult>(response);
        },
        progress: (token, signal) => get(`${kRoot}/v1/progress/${token}`, signal),
        similar(model, parameters, signal) {
            return get(`${pathOf(model)}/similar?${encodeSearch(parameters)}`, signal);
        },
        compare(a, b, parameters, signal) {
            return get(`${kRoot}/v1/compare?${encodeComparison(a, b, parameters)}`, signal);
        },
        models: (filter, stretch, signal) =>
            get(`${kRoot}/v1/models?${encodeList(filter, stretch)}`, signal),
        facets(filter, signal, withLoops = false) {
            const query = encodeFilter(filter);
            if (withLoops) {
                query.set('include', 'loops');
            }
            return get(`${kRoot}/v1/facets?${query}`, signal);
        },
        model: (id, signal) => get(`${kRoot}/v1/models/${id}`, signal),
        mesh: (model, signal) => get(`${pathOf(model)}/mesh`, signal),
        skeleton: (model, signal) => get(`${pathOf(model)}/skeleton`, signal),
        segments: (model, signal) => get(`${pathOf(model)}/segments`, signal),
        rig: (model, signal) =>
            file(`${pathOf(model)}/rig.glb`, 'model/gltf-binary', signal ? { signal } : {}),
        evaluation: (ranker, signal) => get(evaluationPath(ranker), signal),
        async evaluatedQueries(ranker, signal) {
            const path = `${evaluationPath(ranker)}?include=queries`;
            return (await get<Evaluation>(path, signal)).queries ?? [];
        },
    };
}
