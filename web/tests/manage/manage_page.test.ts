import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import type { Administration } from '../../src/api/administration';
import { ApiError } from '../../src/api/problem';
import { managePage } from '../../src/manage/manage_page';
import { kUndoMs } from '../../src/manage/pending_removal';
import { adminKey, keepAdminKey } from '../../src/page/admin_key';
import type { Page } from '../../src/page/context';
import { contextWith, eventually, settled } from '../sample';

let page: Page | null = null;

beforeEach(() => sessionStorage.clear());
afterEach(() => {
    vi.useRealTimers();
    page?.dispose();
    page = null;
});

const kFailure = {
    path: 'old/knot.off',
    content_hash: null,
    code: 'mesh_empty',
    message: 'there are no faces',
    failed_at: '2026-01-01T00:00:00Z',
};

function administration(methods: Partial<Administration> = {}): Administration {
    return {
        failures: async () => [kFailure],
        add: async () => 4,
        job: async () => ({ id: 4, state: 'done', model: 12, error: null }),
        jobs: async () => [],
        remove: async () => {},
        classify: async () => {},
        ...methods,
    };
}

async function entered(methods: Partial<Administration> = {}) {
    keepAdminKey('a key of sixteen');
    const context = contextWith({});
    const made = administration(methods);
    page = managePage(context, () => made);
    await page.ready;
    const press = (label: string) =>
        [...(page?.node.querySelectorAll('button') ?? [])]
            .find((each) => each.textContent === label)
            ?.click();
    return { context, node: page.node, press };
}

const kChosen = { id: 7, name: 'ant', path: 'ant.off', class: null };

it('asks for the key, and keeps it for the session once the server has taken it', async () => {
    const make = vi.fn(() => administration());
    page = managePage(contextWith({}), make);
    await page.ready;
    const field = page.node.querySelector<HTMLInputElement>('input[name=key]');
    expect(field?.type).toBe('password');
    Object.assign(field as HTMLInputElement, { value: ' sesame, sesame, open ' });
    page.node.querySelector('form')?.dispatchEvent(new Event('submit', { cancelable: true }));
    await settled();
    expect(make).toHaveBeenLastCalledWith('sesame, sesame, open');
    expect(page.node.querySelector('#failures-title')).not.toBeNull();
    expect(adminKey()).toBe('sesame, sesame, open');
});

it('forgets a key that is wrong, and says so', async () => {
    const { node } = await entered({
        failures: () =>
            Promise.reject(
                new ApiError({ title: 'No', status: 401, detail: '', code: 'admin_key_wrong' }),
            ),
    });
    expect(node.querySelector('.notice-code')?.textContent).toBe('admin_key_wrong');
    expect(node.querySelector('input[name=key]')).not.toBeNull();
    expect(adminKey()).toBe('');
});

it('says of files that could not be indexed why, and what to do', async () => {
    const { node } = await entered();
    const row = node.querySelector('.failures tbody tr')?.textContent;
    expect(row).toContain('old/knot.off');
    expect(row).toContain('mesh_empty');
    expect(row).toContain('modelling program');
});

it('adds files one after the other and follows their jobs', async () => {
    const added: string[] = [];
    const { node } = await entered({
        add: async (file, className, onSent) => {
            onSent(0.5);
            added.push(`${file.name} ${className}`);
            return added.length;
        },
        job: async (id) =>
            id === 1
                ? { id, state: 'done', model: 12, error: null }
                : {
                      id,
                      state: 'failed',
                      model: null,
                      error: { code: 'off_header', message: 'no' },
                  },
    });
    const [className, files] = node.querySelectorAll<HTMLInputElement>('.manage-form input');
    Object.assign(className as HTMLInputElement, { value: 'ants' });
    Object.defineProperty(files, 'files', {
        value: [new File(['a'], 'a.off'), new File(['b'], 'b.off')],
    });
    files?.dispatchEvent(new Event('change'));
    await eventually(() => {
        const [first, second] = node.querySelectorAll('.added-models li');
        expect(first?.querySelector('a')?.getAttribute('href')).toBe('#/models/12');
        expect(second?.textContent).toContain('off_header');
        expect(second?.textContent).toContain('export it again');
    });
    expect(added).toEqual(['a.off ants', 'b.off ants']);
});

it('removes only once ten seconds have passed', async () => {
    const remove = vi.fn(async () => {});
    const { context, press } = await entered({ remove });
    context.selection.set(kChosen, true);
    vi.useFakeTimers();
    press('Remove them');
    expect(context.selection.list).toEqual([]);
    await vi.advanceTimersByTimeAsync(kUndoMs - 100);
    expect(remove).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(200);
    expect(remove).toHaveBeenCalledExactlyOnceWith(7);
});

it('removes nothing where that is taken back in time', async () => {
    const remove = vi.fn(async () => {});
    const { context, press } = await entered({ remove });
    context.selection.set(kChosen, true);
    vi.useFakeTimers();
    press('Remove them');
    await vi.advanceTimersByTimeAsync(5000);
    press('Undo');
    await vi.advanceTimersByTimeAsync(2 * kUndoMs);
    expect(remove).not.toHaveBeenCalled();
    expect(context.selection.list).toEqual([kChosen]);
});

it('sets the class of all that are chosen', async () => {
    const classify = vi.fn(async () => {});
    const { context, node } = await entered({ classify });
    context.selection.set(kChosen, true);
    context.selection.set({ ...kChosen, id: 8 }, true);
    const form = node.querySelector('.manage-chosen form');
    Object.assign(form?.querySelector('input') as HTMLInputElement, { value: 'insects' });
    form?.dispatchEvent(new Event('submit', { cancelable: true }));
    await settled();
    expect(classify.mock.calls).toEqual([
        [7, 'insects'],
        [8, 'insects'],
    ]);
    expect(context.selection.list.map((each) => each.class)).toEqual(['insects', 'insects']);
});
