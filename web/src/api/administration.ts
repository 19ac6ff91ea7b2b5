import { ApiError, isAbort, problemFrom, unreachable } from './problem';
import { kRoot } from './root';
import { sendForm, type SentForm } from './send_form';
import type { FailureList, Job, Jobs } from './types';

export type IndexFailure = FailureList['failures'][number];
export type ListedJob = Jobs['jobs'][number];

/** What whoever has the administrator's key may do. Every failure but an abort is an ApiError. */
export interface Administration {
    /** Errors: admin_key_wrong, admin_disabled. */
    failures(signal?: AbortSignal): Promise<IndexFailure[]>;
    /** The job that adds the model. `onSent` is told the share of the file that is on its way. */
    add(
        file: File,
        className: string,
        onSent: (share: number) => void,
        signal?: AbortSignal,
    ): Promise<number>;
    job(id: number, signal?: AbortSignal): Promise<Job>;
    /** The last ones, the newest first, whoever added them. */
    jobs(signal?: AbortSignal): Promise<ListedJob[]>;
    remove(model: number): Promise<void>;
    /** An empty name: no class. */
    classify(model: number, className: string): Promise<void>;
}

export interface AdministrationOptions {
    fetch: typeof fetch;
    send: (form: SentForm) => Promise<Response>;
}

const kDefaults: AdministrationOptions = {
    fetch: (input, init) => globalThis.fetch(input, init),
    send: sendForm,
};

async function answered<T>(response: Response): Promise<T> {
    const body: unknown = response.status === 204 ? {} : await response.json().catch(() => null);
    if (!response.ok || typeof body !== 'object' || body === null) {
        const id = response.headers.get('X-Request-Id') ?? undefined;
        throw new ApiError(problemFrom(response.status, body, id));
    }
    return body as T;
}

export function createAdministration(
    key: string,
    options: Partial<AdministrationOptions> = {},
): Administration {
    const { fetch, send } = { ...kDefaults, ...options };
    const headers = {
        Accept: 'application/json, application/problem+json',
        Authorization: `Bearer ${key}`,
    };

    async function request<T>(path: string, init: RequestInit = {}): Promise<T> {
        let response: Response;
        try {
            response = await fetch(path, { ...init, headers });
        } catch (error) {
            throw isAbort(error) ? error : unreachable();
        }
        return answered<T>(response);
    }

    return {
        async failures(signal) {
            return (await request<FailureList>(`${kRoot}/v1/failures`, signal ? { signal } : {}))
                .failures;
        },
        async add(file, className, onSent, signal) {
            const body = new FormData();
            body.append('model', file, file.name);
            const query = className === '' ? '' : `?${new URLSearchParams({ class: className })}`;
            const response = await send({
                path: `${kRoot}/v1/models${query}`,
                headers,
                body,
                onSent,
                ...(signal ? { signal } : {}),
            });
            const { job } = await answered<{ job: string }>(response);
            return Number(job.slice(job.lastIndexOf('/') + 1));
        },
        job: (id, signal) => request<Job>(`${kRoot}/v1/jobs/${id}`, signal ? { signal } : {}),
        async jobs(signal) {
            return (await request<Jobs>(`${kRoot}/v1/jobs?limit=100`, signal ? { signal } : {}))
                .jobs;
        },
        async remove(model) {
            await request(`${kRoot}/v1/models/${model}`, { method: 'DELETE' });
        },
        async classify(model, className) {
            const query = new URLSearchParams({ class: className });
            await request(`${kRoot}/v1/models/${model}?${query}`, { method: 'PATCH' });
        },
    };
}
