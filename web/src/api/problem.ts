import type { Problem } from './types';
import { say } from '../words/say';

/** What the page knows of a request that failed; its own failures have codes of their own. */
export type KnownProblem = Pick<Problem, 'title' | 'status' | 'detail'> & {
    code: string;
    request_id?: string;
};

/**
 * Any request that did not end in the answer asked for. `code` is the server's stable code, or one
 * of the page's own where no problem document arrived: `unreachable`, `unexpected_answer`,
 * `local_file`, `local_folder`, `page_part`.
 */
export class ApiError extends Error {
    readonly code: string;
    readonly status: number;
    readonly title: string;
    readonly requestId: string | undefined;

    constructor(problem: KnownProblem) {
        super(problem.detail || problem.title);
        this.name = 'ApiError';
        this.code = problem.code;
        this.status = problem.status;
        this.title = problem.title;
        this.requestId = problem.request_id;
    }
}

function isRecord(value: unknown): value is Record<string, unknown> {
    return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function text(value: unknown): string {
    return typeof value === 'string' ? value : '';
}

/** Takes a body of any kind, since a proxy or a crashed server may answer anything. */
export function problemFrom(status: number, body: unknown, requestId?: string): KnownProblem {
    const fields = isRecord(body) ? body : {};
    const id = text(fields.request_id) || requestId;
    return {
        title: text(fields.title) || say('The server answered with status {status}', { status }),
        status,
        detail: text(fields.detail),
        code: text(fields.code) || 'unexpected_answer',
        ...(id ? { request_id: id } : {}),
    };
}

/** `fetch` rejects without saying more where no answer came at all. */
export function unreachable(): ApiError {
    return new ApiError({
        title: say('The server cannot be reached'),
        status: 0,
        detail: say('The connection was refused or closed before an answer arrived.'),
        code: 'unreachable',
    });
}

/** What stands on this side of the connection: the browser cannot read a file that was given to it. */
export function localFileFault(name: string): ApiError {
    return new ApiError({
        title: say('The file cannot be read'),
        status: 0,
        detail: say(
            '{name}: the browser could not read it. It may have been moved, changed or removed since it was chosen.',
            { name },
        ),
        code: 'local_file',
    });
}

export function isAbort(error: unknown): boolean {
    return error instanceof DOMException && error.name === 'AbortError';
}
