import { expect, it } from 'vitest';

import { knownFacetField } from '../../src/gallery/known_facet_field';
import { KnownFacets } from '../../src/page/known_facets';
import { clientWith, kNoFacets, settled } from '../sample';

it('offers the classes of the collection with their numbers, and keeps the chosen one', async () => {
    const client = clientWith({
        facets: async () => ({
            ...kNoFacets,
            classes: [
                { value: null, models: 9 },
                { value: 'ant', models: 1200 },
            ],
        }),
    });
    const { node, select, dispose } = knownFacetField('classes', 'chair', new KnownFacets(client));
    const offered = () => [...node.querySelectorAll('option')].map((option) => option.textContent);
    expect(offered()).toEqual(['All classes', 'chair']);
    await settled();
    expect(offered()).toEqual(['All classes', 'chair', 'ant (1,200)']);
    expect(select.value).toBe('chair');
    dispose();
});
