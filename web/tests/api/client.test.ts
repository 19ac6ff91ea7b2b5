import { describe, expect, it, vi } from 'vitest';

import { createClient, evaluationPath, kAllModels, pathOf } from '../../src/api/client';
import { ApiError } from '../../src/api/problem';
import { kSearchDefaults } from '../../src/api/search_parameters';
import type { SentForm } from '../../src/api/send_form';
import { searchResult } from '../sample';

function answering(body: unknown, init: ResponseInit = {}) {
    return vi.fn(
        async (_path: string | URL | Request, _init?: RequestInit) =>
            new Response(typeof body === 'string' ? body : JSON.stringify(body), init),
    );
}

function asked(fetch: ReturnType<typeof answering>): { path: URL; init: RequestInit } {
    const [path, init] = fetch.mock.calls[0] ?? [];
    return { path: new URL(String(path), 'http://server'), init: init ?? {} };
}

const kSeven = { kind: 'model', id: 7 } as const;

describe('the client', () => {
    it('uploads the file under its own name and asks for its mesh', async () => {
        const send = vi.fn(async (_form: SentForm) => Response.json(searchResult()));
        const file = new File(['OFF\n0 0 0\n'], 'elephant.off');
        const onSent = vi.fn();
        const parameters = { ...kSearchDefaults, pose: 0.4, className: 'four legs' };
        const result = await createClient({ send }).search(file, parameters, undefined, onSent);
        const form = send.mock.calls[0]?.[0] as SentForm;
        const path = new URL(form.path, 'http://server');
        expect(form.onSent).toBe(onSent);
        expect(path.pathname).toBe('/v1/search');
        expect(path.searchParams.get('include')).toBe('mesh');
        expect(path.searchParams.get('pose')).toBe('0.4');
        expect(path.searchParams.get('class')).toBe('four legs');
        const sent = form.body.get('model') as File;
        expect(sent.name).toBe('elephant.off');
        expect(await sent.text()).toBe('OFF\n0 0 0\n');
        expect(result.hits).toHaveLength(2);
    });

    it('sends filters only where they are set', async () => {
        const fetch = answering({ models: [], next_cursor: null, total: 0, revision: 1 });
        const client = createClient({ fetch, base: 'http://other' });
        const stretch = { sort: 'name', offset: 60, limit: 30 } as const;
        await client.models(kAllModels, stretch);
        expect(asked(fetch).path.search).toBe('?sort=name&offset=60&limit=30');
        fetch.mockClear();
        const filter = {
            ...kAllModels,
            name: 'a b',
            className: 'c&d',
            folder: 'x/y',
            kind: 'stl',
            loops: '3-4',
        };
        await client.models(filter, stretch);
        const { path } = asked(fetch);
        expect(path.origin).toBe('http://other');
        expect(path.searchParams.get('name')).toBe('a b');
        expect(path.searchParams.get('class')).toBe('c&d');
        expect(path.searchParams.get('folder')).toBe('x/y');
        expect(path.searchParams.get('kind')).toBe('stl');
        expect(path.searchParams.get('loops')).toBe('3-4');
        expect(path.searchParams.has('unit')).toBe(false);
    });

    it('fetches a rig as it is, and reads the problem where there is none', async () => {
        const fetch = answering('glTF');
        const rig = await createClient({ fetch }).rig(kSeven);
        expect(new TextDecoder().decode(rig)).toBe('glTF');
        expect(asked(fetch).path.pathname).toBe('/v1/models/7/rig.glb');
        const problem = { title: 'No decomposition', status: 404, code: 'segments_not_available' };
        const refusing = createClient({ fetch: answering(problem, { status: 404 }) });
        await expect(refusing.rig(kSeven)).rejects.toMatchObject({
            code: 'segments_not_available',
        });
    });

    it.each([
        ['mesh', '/v1/models/7/mesh'],
        ['skeleton', '/v1/models/7/skeleton'],
        ['segments', '/v1/models/7/segments'],
    ] as const)('asks for the %s of a model', async (method, path) => {
        const fetch = answering({});
        await createClient({ fetch })[method](kSeven);
        expect(asked(fetch).path.pathname).toBe(path);
        const query = answering({});
        await createClient({ fetch: query })[method]({ kind: 'query', token: 'abc' });
        expect(asked(query).path.pathname).toBe(path.replace('models/7', 'queries/abc'));
    });

    it('turns a problem document into an ApiError with its code', async () => {
        const fetch = answering(
            { title: 'No', status: 404, detail: 'no model 7', code: 'model_not_found' },
            { status: 404, headers: { 'Content-Type': 'application/problem+json' } },
        );
        const failure = await createClient({ fetch })
            .model(7)
            .catch((error: unknown) => error);
        expect(failure).toBeInstanceOf(ApiError);
        expect((failure as ApiError).code).toBe('model_not_found');
    });

    it.each([
        ['a page of HTML', '<html>502</html>', { status: 502 }],
        ['no JSON in spite of 200', 'hello', { status: 200 }],
        ['JSON that is no object', '3', { status: 200 }],
    ])('does not trust %s', async (_, body, init) => {
        const fetch = answering(body, { ...init, headers: { 'X-Request-Id': 'r-9' } });
        const failure = await createClient({ fetch })
            .evaluation('hybrid')
            .catch((error: unknown) => error);
        expect((failure as ApiError).code).toBe('unexpected_answer');
        expect((failure as ApiError).requestId).toBe('r-9');
    });

    it('says that the server is unreachable where the connection fails', async () => {
        const fetch = vi.fn(async () => Promise.reject(new TypeError('Failed to fetch')));
        const failure = await createClient({ fetch })
            .model(1)
            .catch((error: unknown) => error);
        expect((failure as ApiError).code).toBe('unreachable');
    });

    it('lets an abort through as an abort, before and while the body is read', async () => {
        const abort = new DOMException('stopped', 'AbortError');
        const early = vi.fn(async () => Promise.reject(abort));
        await expect(createClient({ fetch: early }).model(1)).rejects.toBe(abort);
        const late = vi.fn(async () => {
            const response = new Response('{}');
            response.json = () => Promise.reject(abort);
            return response;
        });
        await expect(createClient({ fetch: late }).model(1)).rejects.toBe(abort);
    });

    it('passes the signal on', async () => {
        const fetch = answering({});
        const { signal } = new AbortController();
        await createClient({ fetch }).skeleton(kSeven, signal);
        expect(asked(fetch).init.signal).toBe(signal);
    });
});

describe('paths of pictures and reports', () => {
    it('follow the interface', () => {
        expect(pathOf(kSeven)).toBe('/v1/models/7');
        expect(evaluationPath('chain-code', '.svg')).toBe('/v1/evaluations/chain-code.svg');
        expect(evaluationPath('hybrid')).toBe('/v1/evaluations/hybrid');
    });
});
