import { afterEach, expect, it, vi } from 'vitest';

import { ApiError, unreachable } from '../../src/api/problem';
import { partsDialog } from '../../src/gallery/parts_dialog';
import type { ViewerDialog } from '../../src/gallery/viewer_dialog';
import { kSegments, rigFile } from '../rig_sample';
import { clientWith, eventually, searchResult } from '../sample';

let dialog: ViewerDialog | null = null;

afterEach(() => {
    dialog?.dispose();
    dialog = null;
});

function opened(methods: Parameters<typeof clientWith>[0]) {
    dialog = partsDialog(
        {
            model: { kind: 'model', id: 7 },
            query: searchResult().query,
            up: 'y',
            posed: '',
            onPose: vi.fn(),
            onFind: vi.fn(),
            onClose: vi.fn(),
        },
        clientWith(methods),
    );
    document.body.append(dialog.node);
    dialog.open();
    return dialog.node;
}

it('shows the parts of the model', async () => {
    const node = opened({ segments: async () => kSegments, rig: async () => rigFile() });
    await eventually(() => expect(node.querySelectorAll('.part-legend tbody tr')).toHaveLength(2));
    expect(node.querySelector('h2')?.textContent).toBe('Parts of elephant');
    expect(node.querySelector('.dialog-body')?.hasAttribute('aria-busy')).toBe(false);
});

it('says why a model has no parts, and asks again', async () => {
    const none = new ApiError({
        title: 'No decomposition',
        status: 404,
        detail: 'Model 7 cannot be cut into parts: it has no extent',
        code: 'segments_not_available',
    });
    const segments = vi.fn(async () => kSegments).mockRejectedValueOnce(none);
    const node = opened({ segments, rig: async () => rigFile() });
    await eventually(() =>
        expect(node.querySelector('.notice-code')?.textContent).toBe('segments_not_available'),
    );
    node.querySelector<HTMLButtonElement>('.notice button')?.click();
    await eventually(() => expect(node.querySelector('.part-legend')).not.toBeNull());
    expect(segments).toHaveBeenCalledTimes(2);
});

it('shows the problem where the rig does not arrive', async () => {
    const node = opened({
        segments: async () => kSegments,
        rig: () => Promise.reject(unreachable()),
    });
    await eventually(() =>
        expect(node.querySelector('.notice-code')?.textContent).toBe('unreachable'),
    );
});
