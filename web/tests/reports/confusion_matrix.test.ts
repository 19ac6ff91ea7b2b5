import { expect, it, vi } from 'vitest';

import { cellText, confusionMatrix } from '../../src/reports/confusion_matrix';
import { evaluation } from '../sample';

it('has a cell for each pair of classes, in per cent of the row', () => {
    const { confusion } = evaluation();
    const onOpen = vi.fn();
    const node = confusionMatrix(confusion, onOpen);
    const cells = [...node.querySelectorAll('tbody td')].map((cell) => cell.textContent);
    expect(cells).toEqual(['100', '', '20', '80']);
    expect(node.querySelectorAll('.cell-right')).toHaveLength(2);
    expect(node.querySelector('.mistakes')?.textContent).toContain('table for ant20 %');
    node.querySelector<HTMLButtonElement>('.cell-button')?.click();
    expect(onOpen).toHaveBeenLastCalledWith('table', 'ant');
});

it('says nothing of mistakes where there are none', () => {
    const perfect = {
        classes: ['a', 'b'],
        values: [
            [1, 0],
            [0, 1],
        ],
    };
    expect(confusionMatrix(perfect, () => {}).querySelector('.mistakes')).toBeNull();
});

it('leaves nothing blank', () => {
    expect(cellText(0)).toBe('');
    expect(cellText(0.004)).toBe('');
    expect(cellText(0.006)).toBe('1');
    expect(cellText(1)).toBe('100');
});
