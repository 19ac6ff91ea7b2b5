import type { ClassMetrics } from '../api/elements';
import { element, replace } from '../page/element';
import { formatCount, formatShare } from '../page/format';
import {
    type ClassOrder,
    type ClassRow,
    kClassOrder,
    kMetrics,
    sortedClasses,
} from './report_data';
import { type Text, say } from '../words/say';

interface Column {
    key: keyof ClassRow;
    short: Text;
    long: Text;
}

const kColumns: readonly Column[] = [
    { key: 'name', short: 'Class', long: 'Class' },
    { key: 'models', short: 'Models', long: 'Models' },
    ...kMetrics,
];

function cell(row: ClassRow, key: keyof ClassRow): HTMLElement {
    const value = row[key];
    if (typeof value === 'string') {
        return element('th', { scope: 'row' }, element('span', { class: 'name' }, value));
    }
    if (key === 'models') {
        return element('td', { class: 'number' }, formatCount(value));
    }
    return element('td', { class: 'number heat', '--share': value.toFixed(3) }, formatShare(value));
}

/** The same figures class by class; a press on a column's head sorts by it. */
export function classTable(perClass: Readonly<Record<string, ClassMetrics>>): HTMLElement {
    let order: ClassOrder = { ...kClassOrder };
    const body = element('tbody');
    const heads = kColumns.map((column) => {
        const button = element(
            'button',
            { type: 'button', class: 'sort', title: say(column.long) },
            say(column.short),
        );
        const node = element(
            'th',
            { scope: 'col', class: column.key === 'name' ? '' : 'number' },
            button,
        );
        button.addEventListener('click', () => {
            // Names start at A, figures at the best.
            const descending = order.key === column.key ? !order.descending : column.key !== 'name';
            order = { key: column.key, descending };
            show();
        });
        return { column, node };
    });
    function show(): void {
        for (const { column, node } of heads) {
            if (column.key === order.key) {
                node.setAttribute('aria-sort', order.descending ? 'descending' : 'ascending');
            } else {
                node.removeAttribute('aria-sort');
            }
        }
        replace(
            body,
            sortedClasses(perClass, order).map((row) =>
                element(
                    'tr',
                    {},
                    kColumns.map(({ key }) => cell(row, key)),
                ),
            ),
        );
    }
    show();
    return element(
        'div',
        { class: 'table-scroll' },
        element(
            'table',
            { class: 'table class-table' },
            element('caption', { class: 'visually-hidden' }, say('Retrieval figures by class')),
            element(
                'thead',
                {},
                element(
                    'tr',
                    {},
                    heads.map(({ node }) => node),
                ),
            ),
            body,
        ),
    );
}
