import { afterEach, expect, it, vi } from 'vitest';

import { ApiError } from '../../src/api/problem';
import { kSearchDefaults } from '../../src/api/search_parameters';
import { homePage } from '../../src/gallery/home_page';
import type { Page } from '../../src/page/context';
import { resultsOf } from '../../src/page/routes';
import { contextWith, searchResult, settled } from '../sample';

const kRoute = { page: 'home', name: '', className: '' } as const;
const models = async () => ({ models: [], next_cursor: null, total: 0, revision: 1 });

let page: Page | null = null;

afterEach(() => {
    page?.dispose();
    page = null;
});

function drop(file: File): void {
    const event = new Event('drop', { cancelable: true });
    Object.defineProperty(event, 'dataTransfer', { value: { files: [file], types: ['Files'] } });
    window.dispatchEvent(event);
}

it('searches with the dropped file and goes to its results', async () => {
    const result = searchResult();
    const search = vi.fn(async () => result);
    const context = contextWith({ models, search });
    page = homePage(kRoute, context);
    const file = new File(['OFF'], 'elephant.off');
    drop(file);
    expect(page.node.querySelector('[role=progressbar]')).not.toBeNull();
    await settled();
    expect(search).toHaveBeenCalledExactlyOnceWith(file, kSearchDefaults, expect.anything());
    expect(context.upload).toEqual({ file, parameters: kSearchDefaults, result });
    expect(context.visited).toEqual([resultsOf({ kind: 'upload' })]);
});

it('shows the problem of a file that cannot be used, and takes the next one', async () => {
    const search = vi.fn(async () => searchResult());
    search.mockRejectedValueOnce(
        new ApiError({ title: 'No', status: 422, detail: 'line 3', code: 'off_truncated' }),
    );
    const context = contextWith({ models, search });
    page = homePage(kRoute, context);
    drop(new File(['OFF 3'], 'bad.off'));
    await settled();
    expect(page.node.querySelector('.notice-code')?.textContent).toBe('off_truncated');
    expect(page.node.querySelector('[role=progressbar]')).toBeNull();
    expect(context.visited).toEqual([]);
    drop(new File(['OFF'], 'good.off'));
    await settled();
    expect(context.visited).toHaveLength(1);
    expect(page.node.querySelector('.notice-code')).toBeNull();
});

it('stops on Cancel without calling it a problem', async () => {
    const context = contextWith({
        models,
        search: (_file, _parameters, signal) =>
            new Promise((_, reject) => {
                signal?.addEventListener('abort', () =>
                    reject(new DOMException('stopped', 'AbortError')),
                );
            }),
    });
    page = homePage(kRoute, context);
    drop(new File(['OFF'], 'a.off'));
    page.node.querySelector<HTMLButtonElement>('.progress button')?.click();
    await settled();
    expect(page.node.querySelector('.progress')).toBeNull();
    expect(page.node.querySelector('.notice-problem')).toBeNull();
});
