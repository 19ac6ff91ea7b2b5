import { expect, it } from 'vitest';

import { classTable } from '../../src/reports/class_table';
import { evaluation } from '../sample';

function names(node: HTMLElement): (string | null)[] {
    return [...node.querySelectorAll('tbody th')].map((cell) => cell.textContent);
}

function press(node: HTMLElement, label: string): void {
    for (const button of node.querySelectorAll('button')) {
        if (button.textContent === label) {
            button.click();
        }
    }
}

it('is sorted by name, and by a column whose head is pressed, best first', () => {
    const node = classTable(evaluation().per_class);
    expect(names(node)).toEqual(['ant', 'table']);
    expect(node.querySelector('[aria-sort=ascending]')?.textContent).toBe('Class');
    press(node, 'Class');
    expect(names(node)).toEqual(['table', 'ant']);
    press(node, 'NN');
    expect(names(node)).toEqual(['ant', 'table']);
    expect(node.querySelector('[aria-sort=descending]')?.textContent).toBe('NN');
    press(node, 'NN');
    expect(names(node)).toEqual(['table', 'ant']);
    expect(node.querySelectorAll('[aria-sort]')).toHaveLength(1);
});
