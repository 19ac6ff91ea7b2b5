import { afterEach, beforeEach, expect, it } from 'vitest';

import { startApp } from '../src/app';
import { clientWith, evaluation, hit, kMesh, model, searchResult, settled } from './sample';

const client = clientWith({
    models: async () => ({ models: [model(7)], next_cursor: null, total: 1, revision: 1 }),
    similar: async () => searchResult([hit(1)]),
    mesh: async () => kMesh,
    model: async () => model(7),
    evaluation: async (ranker) => evaluation({ ranker }),
});

let stop: () => void = () => {};
const root = document.createElement('div');

beforeEach(() => {
    history.replaceState(null, '', '#/');
    document.body.append(root);
    stop = startApp(root, { client });
});

afterEach(() => {
    stop();
    root.remove();
});

async function go(hash: string): Promise<void> {
    location.hash = hash;
    dispatchEvent(new Event('hashchange'));
    await settled();
}

it('shows the page that the address names, and follows it', async () => {
    await settled();
    expect(document.title).toBe('Search · Ossuary');
    await go('#/models/7');
    expect(document.title).toBe('Results · Ossuary');
    expect(root.querySelectorAll('.hit-card')).toHaveLength(1);
    await go('#/reports');
    expect(root.querySelector('h1')?.textContent).toBe('Reports');
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
