import type { Skeleton } from '../api/types';
import { element } from '../page/element';
import { formatDistance } from '../page/format';
import { say } from '../words/say';
import type { BranchColors, ColoredPair } from './branch_colors';

export interface MatchTableOptions {
    colors: BranchColors;
    query: Skeleton;
    hit: Skeleton;
    /** A row got or lost the pointer or the focus. */
    onChoose: (pair: ColoredPair | null) => void;
    /** Searches for models that have the query's branch of a pair. */
    onFind: (pair: ColoredPair) => void;
}

export interface MatchTable {
    node: HTMLElement;
    highlight(pair: ColoredPair | null): void;
}

/** Lengths as shares of their skeleton's whole, which two models of any size can be compared by. */
export function branchShares(skeleton: Skeleton): Map<number, number> {
    const whole = skeleton.branches.reduce((sum, branch) => sum + branch.length, 0);
    return new Map(
        skeleton.branches.map((branch) => [branch.id, whole > 0 ? branch.length / whole : 0]),
    );
}

function percent(share: number | undefined): string {
    return share === undefined ? '–' : `${(share * 100).toFixed(1)} %`;
}

/** The matched branches, the longest of the query's first. */
export function matchTable(options: MatchTableOptions): MatchTable {
    const { colors, query, hit, onChoose, onFind } = options;
    const queryShares = branchShares(query);
    const hitShares = branchShares(hit);
    const rows = new Map<ColoredPair, HTMLTableRowElement>();
    for (const pair of colors.pairs) {
        const choose = (): void => onChoose(pair);
        const leave = (): void => onChoose(null);
        rows.set(
            pair,
            element(
                'tr',
                {
                    pointerenter: choose,
                    pointerleave: leave,
                    focusin: choose,
                    focusout: leave,
                },
                element(
                    'th',
                    { scope: 'row' },
                    element('span', { class: 'swatch', '--color': pair.color }),
                    pair.number,
                ),
                element('td', { class: 'number' }, percent(queryShares.get(pair.a))),
                element('td', { class: 'number' }, percent(hitShares.get(pair.b))),
                element('td', { class: 'number' }, formatDistance(pair.cost)),
                element(
                    'td',
                    {},
                    element(
                        'button',
                        {
                            type: 'button',
                            class: 'link-button',
                            click: () => onFind(pair),
                            'aria-label': say('Find models with branch {number}', {
                                number: pair.number,
                            }),
                        },
                        say('Find'),
                    ),
                ),
            ),
        );
    }
    const head = [
        say('Branch'),
        say('Query'),
        say('Hit'),
        say('Cost'),
        element('span', { class: 'visually-hidden' }, say('Models with it')),
    ];
    return {
        node: element(
            'div',
            { class: 'match table-scroll' },
            element(
                'table',
                { class: 'table match-table' },
                element('caption', {}, say('Matched branches, lengths as shares of the skeleton')),
                element(
                    'thead',
                    {},
                    element(
                        'tr',
                        {},
                        head.map((name) => element('th', { scope: 'col' }, name)),
                    ),
                ),
                element('tbody', {}, [...rows.values()]),
            ),
            rows.size === 0 && element('p', { class: 'fine' }, say('No branches match.')),
        ),
        highlight(chosen) {
            for (const [pair, row] of rows) {
                row.classList.toggle('chosen', pair === chosen);
            }
        },
    };
}
