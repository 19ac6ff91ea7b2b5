import { afterEach, expect, it, vi } from 'vitest';

import { unreachable } from '../../src/api/problem';
import { comparisonDialog } from '../../src/gallery/comparison_dialog';
import type { ViewerDialog } from '../../src/gallery/viewer_dialog';
import {
    clientWith,
    eventually,
    hit,
    kMesh,
    kSkeleton,
    model,
    searchResult,
    settled,
} from '../sample';

let dialog: ViewerDialog | null = null;

afterEach(() => {
    dialog?.dispose();
    dialog = null;
});

function opened(methods: Parameters<typeof clientWith>[0], onClose = vi.fn(), onNext = vi.fn()) {
    dialog = comparisonDialog(
        {
            query: searchResult().query,
            queryMesh: kMesh,
            queryUp: 'y',
            hit: hit(1),
            nearness: 'very close',
            partsHref: '#/models/101/parts',
            lookHref: '#/models/101/look',
            onFind: vi.fn(),
            onPrevious: null,
            onNext,
            onClose,
        },
        clientWith(methods),
    );
    document.body.append(dialog.node);
    dialog.open();
    return dialog.node;
}

it('shows the matched branches of query and hit', async () => {
    const node = opened({
        mesh: async () => kMesh,
        skeleton: async () => kSkeleton,
        model: async () => model(101),
    });
    await eventually(() => expect(node.querySelectorAll('.match-table tbody tr')).toHaveLength(1));
    expect(node.querySelector('.dialog-body')?.hasAttribute('aria-busy')).toBe(false);
});

it('closes by its button, by Escape and by a press beside it', () => {
    const onClose = vi.fn();
    const node = opened({}, onClose);
    node.querySelector<HTMLButtonElement>('[aria-label=Close]')?.click();
    expect(onClose).toHaveBeenCalledTimes(1);
    const cancel = new Event('cancel', { cancelable: true });
    node.dispatchEvent(cancel);
    expect(cancel.defaultPrevented).toBe(true);
    expect(onClose).toHaveBeenCalledTimes(2);
    node.dispatchEvent(new MouseEvent('click', { bubbles: true }));
    expect(onClose).toHaveBeenCalledTimes(3);
    node.querySelector('h2')?.dispatchEvent(new MouseEvent('click', { bubbles: true }));
    expect(onClose).toHaveBeenCalledTimes(3);
});

it('steps to the next hit by its button and by a key, but not from within a picture', () => {
    const onNext = vi.fn();
    const node = opened({}, vi.fn(), onNext);
    const press = (target: Element | null | undefined, key: string) =>
        target?.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
    node.querySelector<HTMLButtonElement>('#next-hit')?.click();
    press(node, 'ArrowRight');
    expect(onNext).toHaveBeenCalledTimes(2);
    press(node, 'ArrowLeft');
    press(node.appendChild(document.createElement('canvas')), 'ArrowRight');
    expect(onNext).toHaveBeenCalledTimes(2);
    expect(node.querySelector('#better-hit')?.getAttribute('aria-disabled')).toBe('true');
});

it('shows the problem where the hit has gone', async () => {
    const node = opened({
        mesh: () => Promise.reject(unreachable()),
        skeleton: async () => kSkeleton,
        model: async () => model(101),
    });
    await settled();
    await eventually(() =>
        expect(node.querySelector('.notice-code')?.textContent).toBe('unreachable'),
    );
});
