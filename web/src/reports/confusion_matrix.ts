import type { Confusion } from '../api/elements';
import { element } from '../page/element';
import { commonMistakes } from './report_data';

/** Shares as whole per cents; nothing for nothing, so that the mistakes stand out. */
export function cellText(share: number): string {
    const percent = Math.round(share * 100);
    return percent > 0 ? String(percent) : '';
}

/** Class of the query down, class of its nearest neighbour across, in per cent of the row. */
export function confusionMatrix(confusion: Confusion): HTMLElement {
    const { classes, values } = confusion;
    const mistakes = commonMistakes(confusion);
    return element(
        'div',
        { class: 'confusion' },
        element(
            'div',
            { class: 'table-scroll' },
            element(
                'table',
                { class: 'confusion-table' },
                element(
                    'caption',
                    {},
                    'Row: class of the query. Column: class of its nearest neighbour. Per cent of the row.',
                ),
                element(
                    'thead',
                    {},
                    element(
                        'tr',
                        {},
                        element('td', {}),
                        classes.map((name) =>
                            element('th', { scope: 'col' }, element('span', { title: name }, name)),
                        ),
                    ),
                ),
                element(
                    'tbody',
                    {},
                    classes.map((from, row) =>
                        element(
                            'tr',
                            {},
                            element('th', { scope: 'row' }, element('span', {}, from)),
                            classes.map((to, column) => {
                                const share = values[row]?.[column] ?? 0;
                                return element(
                                    'td',
                                    {
                                        class: row === column ? 'cell cell-right' : 'cell',
                                        '--share': share.toFixed(3),
                                        title: `${from} → ${to}: ${(share * 100).toFixed(1)} %`,
                                    },
                                    cellText(share),
                                );
                            }),
                        ),
                    ),
                ),
            ),
        ),
        mistakes.length > 0 &&
            element(
                'div',
                { class: 'mistakes' },
                element('h3', {}, 'Most often mistaken'),
                element(
                    'ol',
                    {},
                    mistakes.map(({ from, to, share }) =>
                        element(
                            'li',
                            {},
                            element('span', {}, `${from} for ${to}`),
                            element('span', { class: 'number' }, `${Math.round(share * 100)} %`),
                        ),
                    ),
                ),
            ),
    );
}
