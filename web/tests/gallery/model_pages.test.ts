import { expect, it, vi } from 'vitest';

import { kAllModels, type ModelFilter, type Stretch } from '../../src/api/client';
import { unreachable } from '../../src/api/problem';
import { kPageSize, ModelPages } from '../../src/gallery/model_pages';
import { clientWith, model } from '../sample';

const kTotal = 10 * kPageSize + 7;

function answering() {
    return vi.fn(async (_filter: ModelFilter, { offset, limit }: Stretch) => ({
        models: Array.from({ length: Math.min(limit, kTotal - offset) }, (_, at) =>
            model(offset + at),
        ),
        next_cursor: null,
        total: kTotal,
        revision: 1,
    }));
}

function pagesOf(models: ReturnType<typeof answering>) {
    const onChange = vi.fn();
    const onProblem = vi.fn();
    const client = clientWith({ models });
    return {
        pages: new ModelPages(client, kAllModels, 'name', { onChange, onProblem }),
        onChange,
        onProblem,
    };
}

it('fetches the pages that are wanted, each once', async () => {
    const models = answering();
    const { pages, onChange } = pagesOf(models);
    await pages.want(kPageSize - 1, kPageSize + 1);
    expect(models.mock.calls.map(([, { offset }]) => offset)).toEqual([0, kPageSize]);
    expect(pages.total).toBe(kTotal);
    expect(pages.at(kPageSize)?.id).toBe(kPageSize);
    expect(pages.at(5 * kPageSize)).toBeUndefined();
    await pages.want(0, 2 * kPageSize);
    expect(models).toHaveBeenCalledTimes(2);
    expect(onChange).toHaveBeenCalledTimes(2);
});

it('gives up what is out of sight, and fetches it when it is wanted again', async () => {
    const signals: AbortSignal[] = [];
    const models = answering();
    models.mockImplementationOnce(((
        _filter: ModelFilter,
        _stretch: Stretch,
        signal: AbortSignal,
    ) => {
        signals.push(signal);
        return new Promise((_, reject) => {
            signal.addEventListener('abort', () => reject(new DOMException('x', 'AbortError')));
        });
    }) as never);
    const { pages, onProblem } = pagesOf(models);
    void pages.want(0, 10);
    await pages.want(5 * kPageSize, 5 * kPageSize + 10);
    expect(signals[0]?.aborted).toBe(true);
    await pages.want(0, 10);
    expect(pages.at(3)?.id).toBe(3);
    expect(onProblem).not.toHaveBeenCalled();
});

it('tells of a page that did not arrive, and asks for it again', async () => {
    const models = answering();
    models.mockRejectedValueOnce(unreachable());
    const { pages, onProblem } = pagesOf(models);
    await pages.want(0, 10);
    expect(onProblem).toHaveBeenCalledOnce();
    expect(pages.total).toBeNull();
    await pages.want(0, 10);
    expect(pages.at(0)?.id).toBe(0);
});
