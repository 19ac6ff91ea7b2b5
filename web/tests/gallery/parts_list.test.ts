import { expect, it } from 'vitest';

import { partsList } from '../../src/gallery/parts_list';

it('shows each part with its value and its share', () => {
    const node = partsList({ skeleton_pairs: 0.3, views: 0.1 });
    expect([...node.querySelectorAll('dt')].map((dt) => dt.textContent)).toEqual([
        'Skeleton pairs',
        'Views',
    ]);
    expect([...node.querySelectorAll('dd')].map((dd) => dd.textContent)).toEqual([
        '0.300',
        '0.100',
    ]);
    const bars = [...node.querySelectorAll<HTMLElement>('.part')];
    expect(bars.map((bar) => bar.style.getPropertyValue('--share'))).toEqual(['0.7500', '0.2500']);
});
