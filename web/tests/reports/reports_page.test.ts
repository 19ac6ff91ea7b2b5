import { afterEach, expect, it } from 'vitest';

import { ApiError, unreachable } from '../../src/api/problem';
import type { Ranker } from '../../src/api/types';
import type { Page } from '../../src/page/context';
import { reportsPage } from '../../src/reports/reports_page';
import { contextWith, evaluation, settled } from '../sample';

let page: Page | null = null;

afterEach(() => {
    page?.dispose();
    page = null;
});

function curveLabel(shown: Page): string | null | undefined {
    return shown.node.querySelector('.curve')?.getAttribute('aria-label');
}

function missing(): ApiError {
    return new ApiError({
        title: 'No such evaluation',
        status: 404,
        detail: 'only one class has two models',
        code: 'evaluation_not_found',
    });
}

it('shows curve, figures, classes and confusion of all rankers', async () => {
    page = reportsPage(contextWith({ evaluation: async (ranker) => evaluation({ ranker }) }));
    await settled();
    expect(curveLabel(page)).toContain('of hybrid, skeleton, chain code;');
    expect(page.node.querySelectorAll('.metrics-table tbody tr')).toHaveLength(3);
    expect(page.node.querySelector('.confusion-table')).not.toBeNull();
    expect(page.node.querySelector('.reports-status')?.childElementCount).toBe(0);
});

it('shows the details of the ranker that is chosen', async () => {
    const share: Record<Ranker, number> = { hybrid: 0.9, skeleton: 0.7, 'chain-code': 0.5 };
    page = reportsPage(
        contextWith({
            evaluation: async (ranker) =>
                evaluation({
                    ranker,
                    confusion: {
                        classes: ['a', 'b'],
                        values: [
                            [share[ranker], 0],
                            [0, 1],
                        ],
                    },
                }),
        }),
    );
    await settled();
    const cell = () => page?.node.querySelector('.cell-right')?.textContent;
    expect(cell()).toBe('90');
    page.node.querySelector<HTMLButtonElement>('button[value=skeleton]')?.click();
    expect(cell()).toBe('70');
    expect(page.node.querySelector('button[value=skeleton]')?.getAttribute('aria-pressed')).toBe(
        'true',
    );
});

it('says clearly that a collection without classes has no report', async () => {
    page = reportsPage(contextWith({ evaluation: () => Promise.reject(missing()) }));
    await settled();
    expect(page.node.textContent).toContain('There is no report on this collection');
    expect(page.node.textContent).toContain('only one class has two models');
    expect(page.node.querySelector('.curve-loading')).toBeNull();
});

it('shows what there is beside the problem of what there is not', async () => {
    page = reportsPage(
        contextWith({
            evaluation: (ranker) =>
                ranker === 'skeleton'
                    ? Promise.reject(unreachable())
                    : Promise.resolve(evaluation({ ranker })),
        }),
    );
    await settled();
    expect(curveLabel(page)).toContain('of hybrid, chain code;');
    expect(page.node.querySelector('.notice-code')?.textContent).toBe('unreachable');
});
