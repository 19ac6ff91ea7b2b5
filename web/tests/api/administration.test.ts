import { expect, it, vi } from 'vitest';

import { createAdministration } from '../../src/api/administration';
import type { SentForm } from '../../src/api/send_form';

function answering(body: unknown, init: ResponseInit = {}) {
    return vi.fn(
        async (_path: string | URL | Request, _init?: RequestInit) =>
            new Response(body === null ? null : JSON.stringify(body), init),
    );
}

it('sends the key with every request, and nowhere in the address', async () => {
    const fetch = answering({ failures: [] });
    await createAdministration('sesame', { fetch }).failures();
    const [path, init] = fetch.mock.calls[0] ?? [];
    expect(path).toBe('/v1/failures');
    expect((init?.headers as Record<string, string>).Authorization).toBe('Bearer sesame');
});

it('gives the number of the job that adds a model', async () => {
    const send = vi.fn(async (_form: SentForm) => Response.json({ job: '/v1/jobs/31' }));
    const file = new File(['OFF'], 'a.off');
    expect(await createAdministration('k', { send }).add(file, 'ant & bee', () => {})).toBe(31);
    const form = send.mock.calls[0]?.[0] as SentForm;
    expect(form.path).toBe('/v1/models?class=ant+%26+bee');
    expect((form.body.get('model') as File).name).toBe('a.off');
    expect(form.headers.Authorization).toBe('Bearer k');
});

it('removes, and takes a class away by an empty one', async () => {
    const fetch = answering(null, { status: 204 });
    await createAdministration('k', { fetch }).remove(7);
    expect(fetch.mock.calls[0]?.[1]?.method).toBe('DELETE');
    const patch = answering({ id: 7 });
    await createAdministration('k', { fetch: patch }).classify(7, '');
    expect(patch.mock.calls[0]?.[0]).toBe('/v1/models/7?class=');
    expect(patch.mock.calls[0]?.[1]?.method).toBe('PATCH');
});

it('tells refusals by their codes', async () => {
    const fetch = answering({ code: 'admin_key_wrong', title: 'No' }, { status: 401 });
    await expect(createAdministration('k', { fetch }).failures()).rejects.toMatchObject({
        code: 'admin_key_wrong',
        status: 401,
    });
});
