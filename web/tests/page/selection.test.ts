import { beforeEach, expect, it, vi } from 'vitest';

import { type Chosen, Selection } from '../../src/page/selection';

const chosen = (id: number): Chosen => ({ id, name: `m${id}`, path: `a/m${id}.off`, class: null });

beforeEach(() => sessionStorage.clear());

it('keeps what is ticked in its order, tells whoever listens, and survives a reload', () => {
    const selection = new Selection();
    const heard = vi.fn();
    const end = selection.subscribe(heard);
    selection.set(chosen(2), true);
    selection.set(chosen(1), true);
    selection.set(chosen(2), true);
    expect(selection.list.map(({ id }) => id)).toEqual([2, 1]);
    selection.set(chosen(2), false);
    expect(heard).toHaveBeenCalledTimes(4);
    end();
    expect(new Selection().list).toEqual([chosen(1)]);
    selection.clear();
    expect(heard).toHaveBeenCalledTimes(4);
    expect(new Selection().has(1)).toBe(false);
});

it('takes nothing that is no list', () => {
    sessionStorage.setItem('ossuary.selection', '{"id":');
    expect(new Selection().list).toEqual([]);
});
