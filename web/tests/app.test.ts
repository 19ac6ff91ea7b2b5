import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import { startApp } from '../src/app';
import {
    clientWith,
    evaluation,
    eventually,
    hit,
    kMesh,
    model,
    searchResult,
    settled,
} from './sample';

const client = clientWith({
    models: async () => ({ models: [model(7)], next_cursor: null, total: 1, revision: 1 }),
    search: async () => ({ ...searchResult([hit(1)]), token: 'a'.repeat(32) }),
    similar: async () => searchResult([hit(1)]),
    mesh: async () => kMesh,
    model: async () => model(7),
    evaluation: async (ranker) => evaluation({ ranker }),
});

let stop: () => void = () => {};
const root = document.createElement('div');

beforeEach(() => {
    history.replaceState(null, '', '#/');
    sessionStorage.clear();
    document.body.append(root);
    stop = startApp(root, { client });
});

afterEach(() => {
    stop();
    root.remove();
});

async function go(hash: string): Promise<void> {
    // As a link would: a step of its own, of which the page knows nothing yet.
    history.pushState(null, '', hash);
    dispatchEvent(new Event('hashchange'));
    await settled();
    await eventually(() => expect(root.querySelector('[aria-busy]')).toBeNull());
    await settled();
}

it('shows the page that the address names, and follows it', async () => {
    await settled();
    expect(document.title).toBe('Search · Ossuary');
    await go('#/models/7');
    expect(document.title).toBe('Models like elephant · Ossuary');
    expect(root.querySelectorAll('.hit-card')).toHaveLength(1);
    await go('#/reports');
    await eventually(() => expect(root.querySelector('h1')?.textContent).toBe('Reports'));
    await go('#/nowhere');
    expect(root.textContent).toContain('There is no such page');
    await go('#/');
    expect(root.querySelectorAll('.card')).toHaveLength(1);
});

it('keeps one main landmark and one status for screen readers', async () => {
    await go('#/models/7');
    expect(root.querySelectorAll('main')).toHaveLength(1);
    expect(root.querySelectorAll('[role=status]')).toHaveLength(1);
    expect(root.querySelector('[role=status]')?.textContent).toContain('1 hit');
});

it('is gone without a trace once it is stopped', async () => {
    stop();
    await go('#/reports');
    expect(root.childElementCount).toBe(0);
});

it('goes back from a comparison to its hits, and from a shared address in its place', async () => {
    await go('#/models/7');
    const steps = history.length;
    await go('#/models/7/hits/101');
    const back = vi.spyOn(history, 'back');
    document.querySelector<HTMLButtonElement>('dialog [aria-label=Close]')?.click();
    expect(back).toHaveBeenCalledOnce();
    back.mockRestore();
    expect(history.length).toBeLessThanOrEqual(steps + 1);
    stop();
    history.replaceState(null, '', '#/models/7/hits/101');
    stop = startApp(root, { client });
    await settled();
    document.querySelector<HTMLButtonElement>('dialog [aria-label=Close]')?.click();
    await settled();
    expect(location.hash).toBe('#/models/7');
    expect(document.querySelector('dialog')).toBeNull();
    expect(document.title).toBe('Models like elephant · Ossuary');
});

it('takes a file that is dropped on any page', async () => {
    await go('#/reports');
    const event = new Event('drop', { cancelable: true });
    const files = [new File(['OFF'], 'a.off')];
    Object.defineProperty(event, 'dataTransfer', { value: { files, types: ['Files'], items: [] } });
    window.dispatchEvent(event);
    await settled();
    expect(location.hash).toBe(`#/q/${'a'.repeat(32)}`);
    expect(root.querySelectorAll('.hit-card')).toHaveLength(1);
});
