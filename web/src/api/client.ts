import type { ModelSummary, PreviewMesh } from './elements';
import { ApiError, isAbort, problemFrom, unreachable } from './problem';
import { encodeSearch, type SearchParameters } from './search_parameters';
import type { Evaluation, ModelPage, Ranker, SearchResult, Segments, Skeleton } from './types';

export interface ClientOptions {
    /** Before every path; empty: the page's own origin. */
    base: string;
    fetch: typeof fetch;
}

const kDefaults: ClientOptions = {
    base: '',
    fetch: (input, init) => globalThis.fetch(input, init),
};

export interface ModelFilter {
    name: string;
    className: string;
    limit: number;
    cursor: string | null;
}

export const kModelFilterDefaults: Readonly<ModelFilter> = {
    name: '',
    className: '',
    limit: 60,
    cursor: null,
};

export interface Client {
    /** The answer holds the query's preview mesh, since the server keeps nothing of an upload. */
    search(file: File, parameters: SearchParameters, signal?: AbortSignal): Promise<SearchResult>;
    similar(id: number, parameters: SearchParameters, signal?: AbortSignal): Promise<SearchResult>;
    models(filter: Partial<ModelFilter>, signal?: AbortSignal): Promise<ModelPage>;
    model(id: number, signal?: AbortSignal): Promise<ModelSummary>;
    mesh(id: number, signal?: AbortSignal): Promise<PreviewMesh>;
    skeleton(id: number, signal?: AbortSignal): Promise<Skeleton>;
    segments(id: number, signal?: AbortSignal): Promise<Segments>;
    /** The preview mesh as binary glTF, a primitive for each part, skinned by the skeleton. */
    rig(id: number, signal?: AbortSignal): Promise<ArrayBuffer>;
    evaluation(ranker: Ranker, signal?: AbortSignal): Promise<Evaluation>;
}

export function thumbnailPath(id: number): string {
    return `/v1/models/${id}/thumbnail.png`;
}

export function evaluationPath(ranker: Ranker, form: '' | '.csv' | '.svg' = ''): string {
    return `/v1/evaluations/${ranker}${form}`;
}

function encodeFilter(filter: Partial<ModelFilter>): URLSearchParams {
    const { name, className, limit, cursor } = { ...kModelFilterDefaults, ...filter };
    const query = new URLSearchParams({ limit: String(limit) });
    if (name !== '') {
        query.set('name', name);
    }
    if (className !== '') {
        query.set('class', className);
    }
    if (cursor !== null) {
        query.set('cursor', cursor);
    }
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
    const { base, fetch } = { ...kDefaults, ...options };

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
        const response = await send(path, 'application/json', init);
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
        search(file, parameters, signal) {
            const query = encodeSearch(parameters);
            query.set('include', 'mesh');
            const body = new FormData();
            body.append('model', file, file.name);
            return request(`/v1/search?${query}`, {
                method: 'POST',
                body,
                ...(signal ? { signal } : {}),
            });
        },
        similar(id, parameters, signal) {
            return get(`/v1/models/${id}/similar?${encodeSearch(parameters)}`, signal);
        },
        models: (filter, signal) => get(`/v1/models?${encodeFilter(filter)}`, signal),
        model: (id, signal) => get(`/v1/models/${id}`, signal),
        mesh: (id, signal) => get(`/v1/models/${id}/mesh`, signal),
        skeleton: (id, signal) => get(`/v1/models/${id}/skeleton`, signal),
        segments: (id, signal) => get(`/v1/models/${id}/segments`, signal),
        rig: (id, signal) =>
            file(`/v1/models/${id}/rig.glb`, 'model/gltf-binary', signal ? { signal } : {}),
        evaluation: (ranker, signal) => get(evaluationPath(ranker), signal),
    };
}
