import { expect, it, vi } from 'vitest';

import { takeAway } from '../../src/gallery/take_away';
import { clientWith, model, settled } from '../sample';

async function linksOf(node: HTMLElement): Promise<Record<string, string | null>> {
    node.toggleAttribute('open', true);
    node.dispatchEvent(new Event('toggle'));
    await settled();
    return Object.fromEntries(
        [...node.querySelectorAll('a')].map((link) => [
            link.textContent,
            link.getAttribute('href'),
        ]),
    );
}

const kSeven = { kind: 'model', id: 7 } as const;
const kOptions = { model: kSeven, name: 'cow', path: 'animals/cow.off' };

it('offers the file and what is made of it where the server gives files', async () => {
    const { links } = model(7);
    const file = '/v1/models/7/file';
    const served = model(7, { links: { ...links, file, stl: '/v1/models/7/mesh.stl' } });
    const node = takeAway(kOptions, clientWith({ model: async () => served }));
    expect(await linksOf(node)).toEqual({
        'The file itself': file,
        STL: '/v1/models/7/mesh.stl',
        'Rigged glTF': '/v1/models/7/rig.glb?detail=full',
        Skeleton: '/v1/models/7/skeleton',
        Parts: '/v1/models/7/segments',
    });
    expect(node.textContent).toContain('animals/cow.off');
});

it('offers what the index holds where it does not', async () => {
    const node = takeAway(kOptions, clientWith({ model: async () => model(7) }));
    expect(await linksOf(node)).toEqual({
        'Rigged glTF': '/v1/models/7/rig.glb',
        Skeleton: '/v1/models/7/skeleton',
        Parts: '/v1/models/7/segments',
    });
});

it('asks the server nothing about an upload, of which it holds everything', async () => {
    const asked = vi.fn();
    const kept = { kind: 'query', token: 'abc' } as const;
    const node = takeAway({ model: kept, name: 'x', path: '' }, clientWith({ model: asked }));
    expect(await linksOf(node)).toMatchObject({
        STL: '/v1/queries/abc/mesh.stl',
        'Rigged glTF': '/v1/queries/abc/rig.glb?detail=full',
    });
    expect(asked).not.toHaveBeenCalled();
});
