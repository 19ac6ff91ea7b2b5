import type { SkeletonBranch } from '../api/elements';
import type { Skeleton } from '../api/types';
import { element } from '../page/element';
import { formatLength } from '../page/format';
import { say } from '../words/say';

export interface BranchTableOptions {
    skeleton: Skeleton;
    unit: string | null;
    /** A row got or lost the pointer or the focus. */
    onChoose: (branch: number | null) => void;
    /** Searches for models that have a branch; null: the page cannot. */
    onFind: ((branch: SkeletonBranch) => void) | null;
}

export interface BranchTable {
    node: HTMLElement;
    highlight(branch: number | null): void;
}

/** The branches of one skeleton, the longest first, each with its chain code. */
export function branchTable({ skeleton, unit, onChoose, onFind }: BranchTableOptions): BranchTable {
    const rows = new Map<number, HTMLTableRowElement>();
    const ordered = [...skeleton.branches].sort((a, b) => b.length - a.length || a.id - b.id);
    for (const branch of ordered) {
        const choose = (): void => onChoose(branch.id);
        const leave = (): void => onChoose(null);
        const find = (): void => onFind?.(branch);
        rows.set(
            branch.id,
            element(
                'tr',
                { pointerenter: choose, pointerleave: leave, focusin: choose, focusout: leave },
                element('th', { scope: 'row' }, rows.size + 1),
                element('td', { class: 'number' }, formatLength(branch.length, unit)),
                element(
                    'td',
                    { class: 'chain-code' },
                    element('code', { tabindex: 0, title: branch.chain_code }, branch.chain_code),
                ),
                onFind &&
                    element(
                        'td',
                        {},
                        element(
                            'button',
                            {
                                type: 'button',
                                class: 'link-button',
                                click: find,
                                'aria-label': say('Find models with branch {number}', {
                                    number: rows.size + 1,
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
        say('Length'),
        say('Chain code'),
        ...(onFind ? [element('span', { class: 'visually-hidden' }, say('Models with it'))] : []),
    ];
    return {
        node: element(
            'div',
            { class: 'table-scroll' },
            element(
                'table',
                { class: 'table match-table branch-table' },
                element('caption', {}, say('Branches of the skeleton')),
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
        ),
        highlight(chosen) {
            for (const [branch, row] of rows) {
                row.classList.toggle('chosen', branch === chosen);
            }
        },
    };
}
