import { kRankers } from '../api/elements';
import { ApiError, isAbort } from '../api/problem';
import type { Evaluation, Ranker } from '../api/types';
import type { Context, Page } from '../page/context';
import { element, replace } from '../page/element';
import { capitalise, formatCount, formatName, formatPlural } from '../page/format';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { classTable } from './class_table';
import { confusionMatrix } from './confusion_matrix';
import { type CurveChart, curveChart } from './curve_chart';
import { metricsTable } from './metrics_table';

function figure(value: string, name: string): HTMLElement {
    return element('div', {}, element('dt', {}, name), element('dd', { class: 'number' }, value));
}

function noEvaluation(detail: string): HTMLElement {
    return emptyNotice(
        'There is no report on this collection.',
        'A report needs at least two classes with two models each. Name the classes with ',
        element('code', {}, 'ossuary index --classes FILE.cla'),
        `. ${detail}`,
    );
}

/** Detail of one ranker: figures by class and what is taken for what. */
function detail(evaluation: Evaluation): HTMLElement[] {
    return [
        element(
            'section',
            { class: 'panel', 'aria-labelledby': 'classes-title' },
            element('h2', { id: 'classes-title' }, 'By class'),
            classTable(evaluation.per_class),
        ),
        element(
            'section',
            { class: 'panel', 'aria-labelledby': 'confusion-title' },
            element('h2', { id: 'confusion-title' }, 'Confusion'),
            confusionMatrix(evaluation.confusion),
        ),
    ];
}

/** How well the rankers find models of the query's class. */
export function reportsPage(context: Context): Page {
    const running = new AbortController();
    const found: Evaluation[] = [];
    const status = element('div', { class: 'reports-status' });
    const figures = element('dl', { class: 'figures' });
    const curve = element('div', { class: 'curve-place curve-loading' });
    const metrics = element('div', {});
    const choice = element('div', { class: 'segmented', role: 'group', 'aria-label': 'Ranker' });
    const details = element('div', { class: 'report-details' });
    const overview = element(
        'section',
        { class: 'panel', 'aria-labelledby': 'curve-title' },
        element('h2', { id: 'curve-title' }, 'Precision and recall'),
        curve,
        metrics,
    );
    const detailHead = element(
        'div',
        { class: 'section-head', hidden: true },
        element('h2', {}, 'In detail'),
        choice,
    );
    let chart: CurveChart | null = null;
    let chosen: Ranker | null = null;

    const choose = (ranker: Ranker): void => {
        chosen = ranker;
        const evaluation = found.find((each) => each.ranker === ranker);
        for (const button of choice.querySelectorAll('button')) {
            button.setAttribute('aria-pressed', String(button.value === ranker));
        }
        if (evaluation) {
            replace(details, detail(evaluation));
        }
    };
    const show = (): void => {
        const [first] = found;
        if (!first) {
            return;
        }
        replace(figures, [
            figure(formatCount(first.models), 'models'),
            figure(formatCount(first.classes), 'classes'),
        ]);
        chart?.dispose();
        chart = curveChart(found);
        curve.classList.remove('curve-loading');
        replace(curve, chart.node);
        replace(metrics, metricsTable(found));
        detailHead.hidden = false;
        replace(
            choice,
            found.map(({ ranker }) =>
                element(
                    'button',
                    { type: 'button', value: ranker, click: () => choose(ranker) },
                    capitalise(formatName(ranker)),
                ),
            ),
        );
        choose(chosen ?? first.ranker);
    };
    // One after the other: each may have to be computed, and the first is to be seen soon.
    const load = async (): Promise<void> => {
        found.length = 0;
        const failures: [Ranker, unknown][] = [];
        for (const ranker of kRankers) {
            replace(
                status,
                element('p', { class: 'fine working' }, `Evaluating ${formatName(ranker)}…`),
            );
            try {
                found.push(await context.client.evaluation(ranker, running.signal));
                show();
            } catch (error) {
                if (isAbort(error)) {
                    return;
                }
                failures.push([ranker, error]);
            }
        }
        const missing = failures.find(
            ([, error]) => error instanceof ApiError && error.code === 'evaluation_not_found',
        );
        if (found.length === 0 && missing) {
            overview.remove();
            replace(status, noEvaluation((missing[1] as ApiError).message));
        } else {
            replace(
                status,
                failures.map(([, error]) => problemNotice(error, { retry: () => void load() })),
            );
        }
        context.announce(`${formatPlural(found.length, 'report')} shown`);
    };
    void load();
    return {
        node: element(
            'div',
            { class: 'page reports' },
            element(
                'div',
                { class: 'reports-head' },
                element(
                    'div',
                    {},
                    element('h1', {}, 'Reports'),
                    element(
                        'p',
                        { class: 'lede' },
                        'Every model of the collection searches for the others of its class.',
                    ),
                ),
                figures,
            ),
            status,
            overview,
            detailHead,
            details,
        ),
        title: 'Reports',
        update: (route) => route.page === 'reports',
        dispose() {
            running.abort();
            chart?.dispose();
        },
    };
}
