import type { Confusion } from '../api/elements';
import { element } from '../page/element';
import { commonMistakes } from './report_data';
import { say } from '../words/say';

/** Shares as whole per cents; nothing for nothing, so that the mistakes stand out. */
export function cellText(share: number): string {
    const percent = Math.round(share * 100);
    return percent > 0 ? String(percent) : '';
}

/**
 * Class of the query down, class of its nearest neighbour across, in per cent of the row. Cells off the
 * diagonal open the models behind them.
 */
export function confusionMatrix(
    confusion: Confusion,
    onOpen: (from: string, to: string) => void,
): HTMLElement {
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
                    say(
                        'Row: class of the query. Column: class of its nearest neighbour. Per cent of the row.',
                    ),
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
                                    row !== column && cellText(share) !== ''
                                        ? element(
                                              'button',
                                              {
                                                  type: 'button',
                                                  class: 'cell-button',
                                                  'aria-label': say('{from} taken for {to}', {
                                                      from,
                                                      to,
                                                  }),
                                                  click: () => onOpen(from, to),
                                              },
                                              cellText(share),
                                          )
                                        : cellText(share),
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
                element('h3', {}, say('Most often mistaken')),
                element(
                    'ol',
                    {},
                    mistakes.map(({ from, to, share }) =>
                        element(
                            'li',
                            {},
                            element('span', {}, say('{from} for {to}', { from, to })),
                            element('span', { class: 'number' }, `${Math.round(share * 100)} %`),
                        ),
                    ),
                ),
            ),
    );
}
