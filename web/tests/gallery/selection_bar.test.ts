import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import { modelCard } from '../../src/gallery/model_card';
import { listOf, selectionBar } from '../../src/gallery/selection_bar';
import { contextWith, model, settled } from '../sample';

beforeEach(() => sessionStorage.clear());
afterEach(() => {
    document.body.replaceChildren();
    vi.unstubAllGlobals();
});

function barWith(...ids: number[]) {
    const context = contextWith({});
    const bar = selectionBar(context);
    const cards = ids.map((id) => modelCard(model(id), context.selection));
    document.body.append(...cards, bar.node);
    const boxes = cards.map((card) => card.querySelector('input') as HTMLInputElement);
    const tick = (at: number) => boxes[at]?.click();
    const press = (label: string) =>
        [...bar.node.querySelectorAll('button')]
            .find((each) => each.textContent === label)
            ?.click();
    return { context, bar, boxes, tick, press };
}

it('is not there before something is ticked, and compares two', () => {
    const { bar, tick } = barWith(4, 9, 2);
    expect(bar.node.hidden).toBe(true);
    tick(0);
    expect(bar.node.hidden).toBe(false);
    expect(bar.node.querySelector('button')?.disabled).toBe(true);
    tick(1);
    expect(bar.node.querySelector('a')?.getAttribute('href')).toBe('#/models/4/hits/9');
    expect(bar.node.textContent).toContain('2 selected');
    tick(2);
    expect(bar.node.querySelector('a')).toBeNull();
});

it('copies the paths, and says so', async () => {
    const writeText = vi.fn(async () => {});
    vi.stubGlobal('navigator', { clipboard: { writeText } });
    const { context, tick, press } = barWith(4, 9);
    tick(0);
    tick(1);
    press('Copy paths');
    await settled();
    expect(writeText).toHaveBeenCalledWith('models/model4.off\nmodels/model9.off');
    expect(context.announced).toEqual(['Copied']);
});

it('unticks the cards when it is cleared', () => {
    const { bar, boxes, tick, press } = barWith(4);
    tick(0);
    press('Clear');
    expect(boxes[0]?.checked).toBe(false);
    expect(bar.node.hidden).toBe(true);
});

it('writes a list that a spreadsheet reads', () => {
    expect(listOf([{ id: 3, name: 'a,b', path: 'x/y.off', class: 'cow' }])).toBe(
        'id,name,class,path\r\n3,"a,b",cow,x/y.off\r\n',
    );
});
