import { evaluationPath } from '../api/client';
import type { Evaluation } from '../api/types';
import { element } from '../page/element';
import { capitalise, formatName, formatShare } from '../page/format';
import { rankerColorName } from './ranker_color';
import { bestRows, kMetrics } from './report_data';
import { say, sayName } from '../words/say';

/** Where a figure would lie for other queries of the same kind. */
function interval({ low, high }: { low: number; high: number }): HTMLElement {
    const text = `${formatShare(low)}–${formatShare(high)}`;
    return element(
        'span',
        { class: 'interval', title: say('95 % interval, by resampling the queries') },
        text,
    );
}

/** The six figures of each ranker; the best of a column stands out. */
export function metricsTable(evaluations: readonly Evaluation[]): HTMLElement {
    const best = bestRows(evaluations);
    return element(
        'div',
        { class: 'table-scroll' },
        element(
            'table',
            { class: 'table metrics-table' },
            element('caption', { class: 'visually-hidden' }, say('Retrieval figures by ranker')),
            element(
                'thead',
                {},
                element(
                    'tr',
                    {},
                    element('th', { scope: 'col' }, say('Ranker')),
                    kMetrics.map(({ short, long }) =>
                        element(
                            'th',
                            { scope: 'col', class: 'number' },
                            element('abbr', { title: say(long) }, say(short)),
                        ),
                    ),
                    element('th', { scope: 'col' }, say('Curve')),
                ),
            ),
            element(
                'tbody',
                {},
                evaluations.map((evaluation, row) =>
                    element(
                        'tr',
                        {},
                        element(
                            'th',
                            { scope: 'row' },
                            element('span', {
                                class: 'swatch',
                                '--color': `var(${rankerColorName(evaluation.ranker)})`,
                            }),
                            capitalise(sayName(formatName(evaluation.ranker))),
                        ),
                        kMetrics.map(({ key }) =>
                            element(
                                'td',
                                { class: best.get(key) === row ? 'number best' : 'number' },
                                formatShare(evaluation[key]),
                                interval(evaluation.intervals[key]),
                            ),
                        ),
                        element(
                            'td',
                            { class: 'downloads' },
                            (['.csv', '.svg'] as const).map((form) =>
                                element(
                                    'a',
                                    {
                                        href: evaluationPath(evaluation.ranker, form),
                                        download: `${evaluation.ranker}${form}`,
                                        'aria-label': say('Curve of {ranker} as {form}', {
                                            ranker: evaluation.ranker,
                                            form: form.slice(1).toUpperCase(),
                                        }),
                                    },
                                    form.slice(1).toUpperCase(),
                                ),
                            ),
                        ),
                    ),
                ),
            ),
        ),
    );
}
