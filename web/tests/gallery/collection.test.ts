import { afterEach, expect, it, vi } from 'vitest';

import type { ModelFilter } from '../../src/api/client';
import { unreachable } from '../../src/api/problem';
import type { ModelPage } from '../../src/api/types';
import { type Collection, collection } from '../../src/gallery/collection';
import { contextWith, model, settled } from '../sample';

let shown: Collection | null = null;

afterEach(() => {
    vi.useRealTimers();
    shown?.dispose();
    shown = null;
});

/** A collection of `count` models that answers three at a time. */
function paged(count: number) {
    return vi.fn(async (filter: Partial<ModelFilter>): Promise<ModelPage> => {
        const start = Number(filter.cursor ?? 0);
        const end = Math.min(count, start + 3);
        return {
            models: Array.from({ length: end - start }, (_, at) => model(start + at + 1)),
            next_cursor: end < count ? String(end) : null,
            total: count,
            revision: 1,
        };
    });
}

function names(node: HTMLElement): string[] {
    return [...node.querySelectorAll('.card-name')].map((name) => name.textContent ?? '');
}

function moreButton(node: HTMLElement): HTMLButtonElement | null {
    return node.querySelector<HTMLButtonElement>('.grid-foot:not([hidden]) button');
}

it('shows page after page until all models are there, each once', async () => {
    const context = contextWith({ models: paged(7) });
    shown = collection({ name: '', className: '' }, context);
    expect(shown.node.querySelectorAll('.card-loading').length).toBeGreaterThan(0);
    await settled();
    expect(names(shown.node)).toEqual(['model1', 'model2', 'model3']);
    for (let step = 0; step < 2; step++) {
        moreButton(shown.node)?.click();
        await settled();
    }
    expect(names(shown.node)).toHaveLength(7);
    expect(new Set(names(shown.node)).size).toBe(7);
    expect(moreButton(shown.node)).toBeNull();
    expect(context.classes.names).toEqual(['chair']);
});

it('asks once for the filter that typing ends with, and writes it into the address', async () => {
    const models = paged(2);
    const context = contextWith({ models });
    shown = collection({ name: '', className: '' }, context);
    await settled();
    vi.useFakeTimers();
    const input = shown.node.querySelector<HTMLInputElement>('[name=name]');
    for (const text of ['h', 'ho', ' hor ']) {
        if (input) {
            input.value = text;
            input.dispatchEvent(new Event('input', { bubbles: true }));
        }
        vi.advanceTimersByTime(50);
    }
    vi.advanceTimersByTime(1000);
    expect(models).toHaveBeenCalledTimes(2);
    expect(models.mock.calls[1]?.[0]).toMatchObject({ name: 'hor', cursor: null });
    expect(context.visited).toEqual([{ page: 'home', name: 'hor', className: '' }]);
});

it('shows the answer to the last filter even where an earlier one comes later', async () => {
    const answers: ((page: ModelPage) => void)[] = [];
    const context = contextWith({
        models: (_, signal) =>
            new Promise((resolve, reject) => {
                answers.push(resolve);
                signal?.addEventListener('abort', () =>
                    reject(new DOMException('stopped', 'AbortError')),
                );
            }),
    });
    shown = collection({ name: 'a', className: '' }, context);
    shown.show({ name: 'b', className: '' });
    const page = (id: number) => ({
        models: [model(id)],
        next_cursor: null,
        total: 1,
        revision: 1,
    });
    answers[1]?.(page(2));
    await settled();
    answers[0]?.(page(1));
    await settled();
    expect(names(shown.node)).toEqual(['model2']);
});

it('tells an empty collection from filters that nothing fits', async () => {
    shown = collection({ name: '', className: '' }, contextWith({ models: paged(0) }));
    await settled();
    expect(shown.node.textContent).toContain('The collection is empty');
    shown.show({ name: 'zebra', className: '' });
    await settled();
    expect(shown.node.textContent).toContain('No model fits');
});

it('shows a problem and asks again on demand', async () => {
    const models = paged(1);
    models.mockRejectedValueOnce(unreachable());
    shown = collection({ name: '', className: '' }, contextWith({ models }));
    await settled();
    expect(shown.node.querySelector('code')?.textContent).toBe('unreachable');
    expect(shown.node.querySelectorAll('.card-loading')).toHaveLength(0);
    shown.node.querySelector<HTMLButtonElement>('.notice button')?.click();
    await settled();
    expect(names(shown.node)).toEqual(['model1']);
    expect(shown.node.querySelector('.notice')).toBeNull();
});
