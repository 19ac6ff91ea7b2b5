import { expect, it } from 'vitest';

import { unreachable } from '../../src/api/problem';
import { embeddedModel } from '../../src/gallery/embedded_model';
import { clientWith, kMesh, kSkeleton, model } from '../sample';

const kClient = clientWith({
    model: async (id) => model(id, { name: 'ant' }),
    mesh: async () => kMesh,
    skeleton: async () => kSkeleton,
});

it('shows the model that the address names, with a way to the gallery', async () => {
    const root = document.createElement('main');
    await embeddedModel(root, '#/models/7', kClient);
    const link = root.querySelector('a');
    expect(link?.textContent).toBe('ant');
    expect(link?.getAttribute('href')).toBe('/#/models/7/look');
    expect(link?.target).toBe('_blank');
});

it('says so where no model is named, or none can be had', async () => {
    const root = document.createElement('main');
    for (const hash of ['', '#/reports', '#/models/x', '#/q/7']) {
        await embeddedModel(root, hash, kClient);
        expect(root.querySelector('.notice-empty')).not.toBeNull();
    }
    const refused = clientWith({ model: () => Promise.reject(unreachable()) });
    await embeddedModel(root, '#/models/7', refused);
    expect(root.querySelector('.notice-problem')).not.toBeNull();
});
