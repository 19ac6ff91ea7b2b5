import { expect, it, vi } from 'vitest';

import { unreachable } from '../../src/api/problem';
import { KnownClasses } from '../../src/page/known_classes';
import { clientWith, kNoFacets, settled } from '../sample';

const kFacets = { ...kNoFacets, classes: [{ value: 'ant', models: 3 }] };

it('asks the server once, and tells everybody until they leave', async () => {
    const facets = vi.fn(async () => kFacets);
    const classes = new KnownClasses(clientWith({ facets }));
    const stays = vi.fn();
    const leaves = vi.fn();
    classes.subscribe(stays);
    classes.subscribe(leaves)();
    await settled();
    expect(classes.values).toEqual(kFacets.classes);
    expect(stays).toHaveBeenCalledOnce();
    expect(leaves).not.toHaveBeenCalled();
    expect(facets).toHaveBeenCalledOnce();
});

it('asks again where the server could not say', async () => {
    const facets = vi.fn(async () => kFacets).mockRejectedValueOnce(unreachable());
    const classes = new KnownClasses(clientWith({ facets }));
    classes.subscribe(() => {});
    await settled();
    expect(classes.values).toEqual([]);
    classes.subscribe(() => {});
    await settled();
    expect(classes.values).toEqual(kFacets.classes);
});
