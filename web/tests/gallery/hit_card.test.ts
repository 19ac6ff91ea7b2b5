import { expect, it } from 'vitest';

import { hitCard } from '../../src/gallery/hit_card';
import { hit } from '../sample';

it('shows rank, name, class and distance and leads to the comparison', () => {
    const card = hitCard(hit(2, { name: 'camel', class: 'fourleg', distance: 0.1234 }), {
        href: '#/models/7/hits/102',
        partNames: ['skeleton', 'moments'],
        longest: 1,
    });
    const link = card.querySelector('a');
    expect(link?.getAttribute('href')).toBe('#/models/7/hits/102');
    expect(link?.textContent).toContain('Rank 2');
    expect(link?.textContent).toContain('camel');
    expect(link?.textContent).toContain('fourleg');
    expect(link?.textContent).toContain('Distance 0.123');
});

it('draws no bar where all distances are zero', () => {
    const card = hitCard(hit(1, { distance: 0, parts: {} }), {
        href: '#',
        partNames: [],
        longest: 0,
    });
    const bar = card.querySelector<HTMLElement>('.parts-bar');
    expect(bar?.style.getPropertyValue('--length')).toBe('0.0000');
});
