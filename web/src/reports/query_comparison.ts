import type { Client } from '../api/client';
import { kSearchDefaults } from '../api/search_parameters';
import type { Evaluation, QueryMetrics, Ranker } from '../api/types';
import { isAbort } from '../api/problem';
import { csv } from '../page/csv';
import { element, replace } from '../page/element';
import { formatName, formatShare } from '../page/format';
import { problemNotice } from '../page/problem_notice';
import { formatRoute, resultsOf } from '../page/routes';
import { saveText } from '../page/save_file';
import { say, sayName } from '../words/say';

/** One query with its average precision by each of several rankers. */
export interface ComparedQuery {
    model: number;
    name: string;
    class: string;
    precisions: number[];
    /** Between the best and the worst of them. */
    spread: number;
}

/** Queries that all of the lists have, those first on which the rankers differ most. */
export function comparedQueries(lists: readonly (readonly QueryMetrics[])[]): ComparedQuery[] {
    const [first = [], ...others] = lists;
    const known = others.map((list) => new Map(list.map((query) => [query.model, query])));
    return first
        .flatMap((query) => {
            const rest = known.map((list) => list.get(query.model));
            if (rest.some((each) => each === undefined)) {
                return [];
            }
            const precisions = [query, ...(rest as QueryMetrics[])].map(
                (each) => each.mean_average_precision,
            );
            const spread = Math.max(...precisions) - Math.min(...precisions);
            return [
                { model: query.model, name: query.name, class: query.class, precisions, spread },
            ];
        })
        .sort((a, b) => b.spread - a.spread || a.model - b.model);
}

const kMostRows = 40;

function resultsHref(model: number, ranker: Ranker): string {
    return formatRoute(resultsOf({ kind: 'model', id: model }, { ...kSearchDefaults, ranker }));
}

function row(query: ComparedQuery, rankers: readonly Ranker[]): HTMLElement {
    const best = Math.max(...query.precisions);
    return element(
        'tr',
        {},
        element('th', { scope: 'row' }, element('span', { class: 'name' }, query.name)),
        element('td', {}, element('span', { class: 'tag' }, query.class)),
        query.precisions.map((precision, at) =>
            element(
                'td',
                { class: precision === best && query.spread > 0 ? 'number best' : 'number' },
                element(
                    'a',
                    {
                        href: resultsHref(query.model, rankers[at] ?? 'hybrid'),
                        'aria-label': say('{name} by {ranker}: {precision}', {
                            name: query.name,
                            ranker: sayName(formatName(rankers[at] ?? '')),
                            precision: formatShare(precision),
                        }),
                    },
                    formatShare(precision),
                ),
            ),
        ),
    );
}

function table(queries: readonly ComparedQuery[], rankers: readonly Ranker[]): HTMLElement[] {
    const save = (): void =>
        saveText(
            'queries.csv',
            'text/csv',
            csv(queries, [
                ['id', ({ model }) => model],
                ['name', ({ name }) => name],
                ['class', (query) => query.class],
                ...rankers.map(
                    (ranker, at) =>
                        [ranker, (query: ComparedQuery) => query.precisions[at] ?? null] as const,
                ),
            ]),
        );
    const heads = [say('Query'), say('Class'), ...rankers.map((each) => sayName(formatName(each)))];
    return [
        element(
            'div',
            { class: 'table-scroll' },
            element(
                'table',
                { class: 'table' },
                element(
                    'caption',
                    { class: 'fine' },
                    say(
                        'Average precision of each query; those first on which the rankers differ most.',
                    ),
                ),
                element(
                    'thead',
                    {},
                    element(
                        'tr',
                        {},
                        heads.map((head, at) =>
                            element('th', { scope: 'col', class: at > 1 ? 'number' : '' }, head),
                        ),
                    ),
                ),
                element(
                    'tbody',
                    {},
                    queries.slice(0, kMostRows).map((query) => row(query, rankers)),
                ),
            ),
        ),
        element(
            'button',
            { type: 'button', class: 'link-button', click: save },
            say('Save all {count} as CSV', { count: queries.length }),
        ),
    ];
}

/** How well each model finds its class by each ranker, once one asks. */
export function queryComparison(
    evaluations: readonly Evaluation[],
    client: Client,
    signal: AbortSignal,
): HTMLElement {
    const rankers = evaluations.map(({ ranker }) => ranker);
    const body = element('div', { class: 'query-comparison' });
    const node = element(
        'details',
        { class: 'options' },
        element('summary', {}, say('Query by query')),
        body,
    );
    const fill = async (): Promise<void> => {
        replace(body, element('p', { class: 'fine working' }, say('Loading…')));
        try {
            const lists = await Promise.all(
                rankers.map((ranker) => client.evaluatedQueries(ranker, signal)),
            );
            replace(body, table(comparedQueries(lists), rankers));
        } catch (error) {
            if (!isAbort(error)) {
                replace(body, problemNotice(error, { retry: () => void fill() }));
            }
        }
    };
    node.addEventListener('toggle', () => {
        if (node.open && body.childElementCount === 0) {
            void fill();
        }
    });
    return node;
}
