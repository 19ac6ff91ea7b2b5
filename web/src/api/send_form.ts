import { unreachable } from './problem';

export interface SentForm {
    path: string;
    headers: Readonly<Record<string, string>>;
    body: FormData;
    /** Told the share of the body that is on its way, from 0 to 1. */
    onSent: (share: number) => void;
    signal?: AbortSignal;
}

const kBodyless: readonly number[] = [204, 205, 304];

function headersOf(request: XMLHttpRequest): Headers {
    const headers = new Headers();
    for (const line of request.getAllResponseHeaders().split('\r\n')) {
        const colon = line.indexOf(': ');
        if (colon > 0) {
            headers.append(line.slice(0, colon), line.slice(colon + 2));
        }
    }
    return headers;
}

/** Sends a form by POST. `fetch` does not tell how much of a body has gone. */
export function sendForm({ path, headers, body, onSent, signal }: SentForm): Promise<Response> {
    return new Promise((resolve, reject) => {
        const request = new XMLHttpRequest();
        const aborted = (): void => reject(new DOMException('aborted', 'AbortError'));
        if (signal?.aborted) {
            aborted();
            return;
        }
        signal?.addEventListener('abort', () => request.abort(), { once: true });
        request.upload.addEventListener('progress', ({ loaded, total }) =>
            onSent(total > 0 ? loaded / total : 0),
        );
        request.upload.addEventListener('load', () => onSent(1));
        request.addEventListener('abort', aborted);
        request.addEventListener('error', () => reject(unreachable()));
        request.addEventListener('load', () => {
            const { status, response } = request;
            const text = kBodyless.includes(status) ? null : (response as string);
            resolve(new Response(text, { status, headers: headersOf(request) }));
        });
        request.open('POST', path);
        for (const [name, value] of Object.entries(headers)) {
            request.setRequestHeader(name, value);
        }
        request.send(body);
    });
}
