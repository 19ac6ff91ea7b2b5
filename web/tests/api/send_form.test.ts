import { afterEach, expect, it, vi } from 'vitest';

import { type SentForm, sendForm } from '../../src/api/send_form';

/** What stands in for the browser's own request. */
class FakeRequest extends EventTarget {
    static last: FakeRequest;
    readonly upload = new EventTarget();
    readonly sent: Record<string, string> = {};
    status = 0;
    response = '';
    path = '';

    constructor() {
        super();
        FakeRequest.last = this;
    }

    open(_method: string, path: string): void {
        this.path = path;
    }

    setRequestHeader(name: string, value: string): void {
        this.sent[name] = value;
    }

    send(): void {}

    abort(): void {
        this.dispatchEvent(new Event('abort'));
    }

    getAllResponseHeaders(): string {
        return 'x-request-id: r-1\r\ncontent-type: application/json\r\n';
    }
}

afterEach(() => {
    vi.unstubAllGlobals();
});

function started(fields: Partial<SentForm> = {}) {
    vi.stubGlobal('XMLHttpRequest', FakeRequest);
    const onSent = vi.fn();
    const form = { path: '/v1/search', headers: { Accept: 'a/b' }, body: new FormData(), onSent };
    return { onSent, answer: sendForm({ ...form, ...fields }) };
}

it('tells how much is on its way, and answers like fetch', async () => {
    const { onSent, answer } = started();
    const request = FakeRequest.last;
    expect(request.path).toBe('/v1/search');
    expect(request.sent).toEqual({ Accept: 'a/b' });
    request.upload.dispatchEvent(Object.assign(new Event('progress'), { loaded: 25, total: 100 }));
    request.upload.dispatchEvent(new Event('load'));
    expect(onSent.mock.calls).toEqual([[0.25], [1]]);
    Object.assign(request, { status: 422, response: '{"code":"off_header"}' });
    request.dispatchEvent(new Event('load'));
    const response = await answer;
    expect(response.status).toBe(422);
    expect(response.headers.get('X-Request-Id')).toBe('r-1');
    expect(await response.json()).toEqual({ code: 'off_header' });
});

it('says that the server is unreachable where the connection fails', async () => {
    const { answer } = started();
    FakeRequest.last.dispatchEvent(new Event('error'));
    await expect(answer).rejects.toMatchObject({ code: 'unreachable' });
});

it('ends when it is told to, also before it began', async () => {
    const abort = new AbortController();
    const { answer } = started({ signal: abort.signal });
    abort.abort();
    await expect(answer).rejects.toMatchObject({ name: 'AbortError' });
    await expect(started({ signal: abort.signal }).answer).rejects.toMatchObject({
        name: 'AbortError',
    });
});
