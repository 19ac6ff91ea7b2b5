import '../styles/reports.css';
import type { Client } from '../api/client';
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

/** The evaluations found so far: the curves and figures of all, the details of a chosen one. */
class Reports {
    readonly figures = element('dl', { class: 'figures' });
    readonly overview: HTMLElement;
    readonly detailHead: HTMLElement;
    readonly details = element('div', { class: 'report-details' });
    private readonly curve_ = element('div', { class: 'curve-place curve-loading' });
    private readonly metrics_ = element('div', {});
    private readonly choice_ = element('div', {
        class: 'segmented',
        role: 'group',
        'aria-label': 'Ranker',
    });
    private found_: readonly Evaluation[] = [];
    private chart_: CurveChart | null = null;
    private chosen_: Ranker | null = null;

    constructor() {
        this.overview = element(
            'section',
            { class: 'panel', 'aria-labelledby': 'curve-title' },
            element('h2', { id: 'curve-title' }, 'Precision and recall'),
            this.curve_,
            this.metrics_,
        );
        this.detailHead = element(
            'div',
            { class: 'section-head', hidden: true },
            element('h2', {}, 'In detail'),
            this.choice_,
        );
    }

    show(found: readonly Evaluation[]): void {
        this.found_ = found;
        const [first] = found;
        if (!first) {
            return;
        }
        replace(this.figures, [
            figure(formatCount(first.models), 'models'),
            figure(formatCount(first.classes), 'classes'),
        ]);
        this.chart_?.dispose();
        this.chart_ = curveChart(found);
        this.curve_.classList.remove('curve-loading');
        replace(this.curve_, this.chart_.node);
        replace(this.metrics_, metricsTable(found));
        this.detailHead.hidden = false;
        const buttons = found.map(({ ranker }) =>
            element(
                'button',
                { type: 'button', value: ranker, click: () => this.choose(ranker) },
                capitalise(formatName(ranker)),
            ),
        );
        replace(this.choice_, buttons);
        this.choose(this.chosen_ ?? first.ranker);
    }

    dispose(): void {
        this.chart_?.dispose();
    }

    private choose(ranker: Ranker): void {
        this.chosen_ = ranker;
        for (const button of this.choice_.querySelectorAll('button')) {
            button.setAttribute('aria-pressed', String(button.value === ranker));
        }
        const evaluation = this.found_.find((each) => each.ranker === ranker);
        if (evaluation) {
            replace(this.details, detail(evaluation));
        }
    }
}

interface Loaded {
    found: Evaluation[];
    failures: unknown[];
}

/**
 * Asks for one evaluation after the other, since each may have to be computed and the first is to be
 * seen soon. Null: it was ended.
 */
async function loadEvaluations(
    client: Client,
    signal: AbortSignal,
    onProgress: (next: Ranker, found: readonly Evaluation[]) => void,
): Promise<Loaded | null> {
    const found: Evaluation[] = [];
    const failures: unknown[] = [];
    for (const ranker of kRankers) {
        onProgress(ranker, found);
        try {
            found.push(await client.evaluation(ranker, signal));
        } catch (error) {
            if (isAbort(error)) {
                return null;
            }
            failures.push(error);
        }
    }
    return { found, failures };
}

function introduction(): HTMLElement {
    return element(
        'div',
        {},
        element('h1', {}, 'Reports'),
        element(
            'p',
            { class: 'lede' },
            'Every model of the collection searches for the others of its class.',
        ),
    );
}

function isMissing(error: unknown): error is ApiError {
    return error instanceof ApiError && error.code === 'evaluation_not_found';
}

/** How well the rankers find models of the query's class. */
export function reportsPage(context: Context): Page {
    const running = new AbortController();
    const status = element('div', { class: 'reports-status' });
    const reports = new Reports();
    const progress = (next: Ranker, found: readonly Evaluation[]): void => {
        reports.show(found);
        const text = `Evaluating ${formatName(next)}…`;
        replace(status, element('p', { class: 'fine working' }, text));
    };
    const load = async (): Promise<void> => {
        const loaded = await loadEvaluations(context.client, running.signal, progress);
        if (!loaded) {
            return;
        }
        const { found, failures } = loaded;
        reports.show(found);
        const missing = failures.find(isMissing);
        if (found.length === 0 && missing) {
            reports.overview.remove();
            replace(status, noEvaluation(missing.message));
        } else {
            const retry = (): void => void load();
            replace(
                status,
                failures.map((error) => problemNotice(error, { retry })),
            );
        }
        context.announce(`${formatPlural(found.length, 'report')} shown`);
    };
    const ready = load();
    return {
        node: element(
            'div',
            { class: 'page reports' },
            element('div', { class: 'reports-head' }, introduction(), reports.figures),
            status,
            reports.overview,
            reports.detailHead,
            reports.details,
        ),
        title: 'Reports',
        ready,
        update: (route) => route.page === 'reports',
        dispose() {
            running.abort();
            reports.dispose();
        },
    };
}
