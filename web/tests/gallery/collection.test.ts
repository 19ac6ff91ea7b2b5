import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import { kAllModels, type ModelFilter, type Stretch } from '../../src/api/client';
import { unreachable } from '../../src/api/problem';
import type { ModelPage } from '../../src/api/types';
import { type Collection, collection } from '../../src/gallery/collection';
import { kHome } from '../../src/page/routes';
import { contextWith, kNoFacets, model, settled } from '../sample';

let shown: Collection | null = null;

beforeEach(() => {
    vi.stubGlobal('innerHeight', 100_000);
});

afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
    shown?.dispose();
    shown?.node.remove();
    shown = null;
});

function open(context: ReturnType<typeof contextWith>, route = kHome): Collection {
    shown = collection(route, context);
    document.body.append(shown.node);
    return shown;
}

function listed(count: number) {
    return vi.fn(
        async (_: ModelFilter, { offset, limit }: Stretch): Promise<ModelPage> => ({
            models: Array.from({ length: Math.max(0, Math.min(limit, count - offset)) }, (_, at) =>
                model(offset + at + 1),
            ),
            next_cursor: null,
            total: count,
            revision: 1,
        }),
    );
}

function names(node: HTMLElement): string[] {
    return [...node.querySelectorAll('.card-name')].map((name) => name.textContent ?? '');
}

it('shows the models in their order, and says where each is in the whole list', async () => {
    const { node } = open(contextWith({ models: listed(7) }));
    expect(node.querySelectorAll('.card-loading').length).toBeGreaterThan(0);
    await settled();
    expect(names(node)).toEqual([1, 2, 3, 4, 5, 6, 7].map((id) => `model${id}`));
    const cards = [...node.querySelectorAll('.virtual-grid > li')];
    expect(cards.map((card) => card.getAttribute('aria-posinset'))).toEqual([...'1234567']);
    expect(cards[0]?.getAttribute('aria-setsize')).toBe('7');
    expect(node.querySelectorAll('.card-loading')).toHaveLength(0);
});

it('has only the cards in sight of a hundred thousand models', async () => {
    vi.stubGlobal('innerHeight', 800);
    const models = listed(100_000);
    const { node } = open(contextWith({ models }));
    await settled();
    expect(node.querySelector('.count')?.textContent).toBe('100,000');
    expect(node.querySelectorAll('.virtual-grid > li').length).toBeLessThan(60);
    expect(models).toHaveBeenCalledOnce();
});

it('begins at the place that the address names', async () => {
    const models = listed(1000);
    open(contextWith({ models }), { ...kHome, at: 600 });
    await settled();
    expect(models.mock.calls[0]?.[1].offset).toBe(600);
});

it('asks once for the filter that typing ends with, and writes it into the address', async () => {
    const models = listed(2);
    const context = contextWith({ models });
    const { node } = open(context);
    await settled();
    vi.useFakeTimers();
    const input = node.querySelector<HTMLInputElement>('[name=name]');
    for (const text of ['h', 'ho', ' hor ']) {
        if (input) {
            input.value = text;
            input.dispatchEvent(new Event('input', { bubbles: true }));
        }
        vi.advanceTimersByTime(50);
    }
    vi.advanceTimersByTime(1000);
    expect(models).toHaveBeenCalledTimes(2);
    const filter = { ...kAllModels, name: 'hor' };
    expect(models.mock.calls[1]?.[0]).toEqual(filter);
    expect(context.visited).toEqual([{ ...kHome, filter }]);
});

it('offers what there is to choose from, with numbers, and asks by it', async () => {
    const models = listed(2);
    const facets = vi.fn(async () => ({
        ...kNoFacets,
        classes: [{ value: 'chair', models: 5 }],
        folders: [{ value: 'old/chairs', models: 2 }],
        kinds: [
            { value: 'off', models: 3 },
            { value: 'stl', models: 4 },
        ],
    }));
    const { node } = open(contextWith({ models, facets }));
    await settled();
    const select = node.querySelector<HTMLSelectElement>('[name=folder]');
    expect([...(select?.options ?? [])].map(({ text }) => text)).toEqual([
        'All folders',
        'old/chairs (2)',
    ]);
    if (select) {
        select.value = 'old/chairs';
        select.dispatchEvent(new Event('change', { bubbles: true }));
    }
    await settled();
    expect(models.mock.calls.at(-1)?.[0]).toEqual({ ...kAllModels, folder: 'old/chairs' });
    expect(facets).toHaveBeenCalledTimes(2);
});

it('has filters by numbers, fetched when they are opened, open where one is set', async () => {
    const models = listed(2);
    const facets = vi.fn(async () => ({
        ...kNoFacets,
        loops: [
            { value: '0', models: 5 },
            { value: '3-4', models: 2 },
        ],
        extents: [{ value: '10-100mm', models: 7 }],
    }));
    const context = contextWith({ models, facets });
    const { node } = open(context);
    await settled();
    expect(node.querySelector('[name=loops]')).toBeNull();
    const details = node.querySelector<HTMLDetailsElement>('.more-filters');
    if (details) {
        details.open = true;
    }
    await vi.waitFor(() => expect(node.querySelector('[name=loops]')).not.toBeNull());
    const select = node.querySelector<HTMLSelectElement>('[name=loops]');
    expect([...(select?.options ?? [])].map(({ text }) => text)).toEqual([
        'Any number',
        '0 (5)',
        '3–4 (2)',
    ]);
    const hidden = [...node.querySelectorAll('.more-filters label')].map(
        (label) => (label as HTMLElement).hidden,
    );
    expect(hidden, 'one value is no choice').toEqual([true, false, true, true]);
    if (select) {
        select.value = '3-4';
        select.dispatchEvent(new Event('change', { bubbles: true }));
    }
    await settled();
    const filter = { ...kAllModels, loops: '3-4' };
    expect(models.mock.calls.at(-1)?.[0]).toEqual(filter);
    expect(context.visited).toEqual([{ ...kHome, filter }]);
    shown?.dispose();
    node.remove();
    const again = open(contextWith({ models, facets }), { ...kHome, filter });
    expect(again.node.querySelector<HTMLDetailsElement>('.more-filters')?.open).toBe(true);
    await vi.waitFor(() =>
        expect(again.node.querySelector<HTMLSelectElement>('[name=loops]')?.value).toBe('3-4'),
    );
});

it('shows the answer to the last filter even where an earlier one comes later', async () => {
    const answers: ((page: ModelPage) => void)[] = [];
    const context = contextWith({
        models: (_filter, _stretch, signal) =>
            new Promise((resolve, reject) => {
                answers.push(resolve);
                signal?.addEventListener('abort', () =>
                    reject(new DOMException('stopped', 'AbortError')),
                );
            }),
    });
    const { node, show } = open(context, { ...kHome, filter: { ...kAllModels, name: 'a' } });
    show.call(shown, { ...kHome, filter: { ...kAllModels, name: 'b' } });
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
    expect(names(node)).toEqual(['model2']);
});

it('tells an empty collection from filters that nothing fits', async () => {
    const opened = open(contextWith({ models: listed(0) }));
    await settled();
    expect(opened.node.textContent).toContain('The collection is empty');
    opened.show({ ...kHome, filter: { ...kAllModels, name: 'zebra' } });
    await settled();
    expect(opened.node.textContent).toContain('No model fits');
});

it('shows a problem and asks again on demand', async () => {
    const models = listed(1);
    models.mockRejectedValueOnce(unreachable());
    const { node } = open(contextWith({ models }));
    await settled();
    expect(node.querySelector('.notice-code')?.textContent).toBe('unreachable');
    expect(node.querySelectorAll('.card-loading')).toHaveLength(0);
    node.querySelector<HTMLButtonElement>('.notice button')?.click();
    await settled();
    expect(names(node)).toEqual(['model1']);
    expect(node.querySelector('.notice')).toBeNull();
});
