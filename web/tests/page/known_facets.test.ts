import { expect, it, vi } from 'vitest';

import { unreachable } from '../../src/api/problem';
import { KnownFacets } from '../../src/page/known_facets';
import { clientWith, kNoFacets, settled } from '../sample';

const kFacets = { ...kNoFacets, classes: [{ value: 'ant', models: 3 }] };

it('asks the server once, and tells everybody until they leave', async () => {
    const facets = vi.fn(async () => kFacets);
    const known = new KnownFacets(clientWith({ facets }));
    const stays = vi.fn();
    const leaves = vi.fn();
    known.subscribe(stays);
    known.subscribe(leaves)();
    await settled();
    expect(known.values('classes')).toEqual(kFacets.classes);
    expect(stays).toHaveBeenCalledOnce();
    expect(leaves).not.toHaveBeenCalled();
    expect(facets).toHaveBeenCalledOnce();
});

it('asks again where the server could not say', async () => {
    const facets = vi.fn(async () => kFacets).mockRejectedValueOnce(unreachable());
    const known = new KnownFacets(clientWith({ facets }));
    known.subscribe(() => {});
    await settled();
    expect(known.values('classes')).toEqual([]);
    known.subscribe(() => {});
    await settled();
    expect(known.values('classes')).toEqual(kFacets.classes);
});
