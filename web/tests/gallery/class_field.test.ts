import { expect, it } from 'vitest';

import { classField } from '../../src/gallery/class_field';
import { KnownClasses } from '../../src/page/known_classes';
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
    const { node, select, dispose } = classField('chair', new KnownClasses(client));
    const offered = () => [...node.querySelectorAll('option')].map((option) => option.textContent);
    expect(offered()).toEqual(['All classes', 'chair']);
    await settled();
    expect(offered()).toEqual(['All classes', 'chair', 'ant (1,200)']);
    expect(select.value).toBe('chair');
    dispose();
});
