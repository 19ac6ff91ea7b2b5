import { expect, it, vi } from 'vitest';

import { inOrder, orderField, orderLabel } from '../../src/gallery/hit_order';
import type { Answer } from '../../src/page/context';
import { searchResult } from '../sample';

function answer(): Answer {
    const result = searchResult();
    const [hit] = result.hits;
    if (!hit) {
        throw new Error('the sample has no hit');
    }
    const hits = [
        { ...hit, rank: 1, id: 1, name: 'leg10', faces: 5, extent: [1, 1, 9] },
        { ...hit, rank: 2, id: 2, name: 'leg2', faces: 7, extent: [2, 3, 1] },
        { ...hit, rank: 3, id: 3, name: 'Arm', faces: 7, extent: [20, 3, 1] },
    ] as typeof result.hits;
    return { ...({ mesh: null, up: 'y' } as unknown as Answer), result: { ...result, hits } };
}

const ids = ({ result }: Answer): number[] => result.hits.map(({ id }) => id);

it('sorts hits, equal ones by their distance, and leaves the answer as it was', () => {
    const found = answer();
    expect(inOrder(found, 'distance')).toBe(found);
    expect(ids(inOrder(found, 'name'))).toEqual([3, 2, 1]);
    expect(ids(inOrder(found, 'faces'))).toEqual([2, 3, 1]);
    expect(ids(inOrder(found, 'size'))).toEqual([3, 1, 2]);
    expect(ids(found)).toEqual([1, 2, 3]);
});

it('has a name for each order, and is there where there is something to sort', () => {
    const onChange = vi.fn();
    const field = orderField(onChange);
    field.show('faces', 1);
    expect(field.node.hidden).toBe(true);
    field.show('faces', 2);
    expect(field.node.hidden).toBe(false);
    const select = field.node.querySelector('select');
    expect(select?.value).toBe('faces');
    expect(field.node.textContent).toContain('Order');
    if (select) {
        select.value = 'name';
        select.dispatchEvent(new Event('change'));
    }
    expect(onChange).toHaveBeenCalledWith('name');
    expect(orderLabel('distance')).toBe('Hits, most similar first');
    expect(orderLabel('size')).toBe('Hits by: Largest first');
});
