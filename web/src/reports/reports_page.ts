import '../styles/reports.css';
import type { Client } from '../api/client';
import { kRankers } from '../api/elements';
import { ApiError, isAbort } from '../api/problem';
import type { Evaluation, Metrics, Ranker } from '../api/types';
import type { Context, Page } from '../page/context';
import { csv } from '../page/csv';
import { element, replace } from '../page/element';
import { saveText } from '../page/save_file';
import { capitalise, formatCount, formatName, formatPlural } from '../page/format';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { classBars } from './class_bars';
import { classTable } from './class_table';
import { ConfusedModels } from './confused_models';
import { confusionMatrix } from './confusion_matrix';
import { type CurveChart, curveChart } from './curve_chart';
import { metricsTable } from './metrics_table';
import { queryComparison } from './query_comparison';
import { kMetrics } from './report_data';
import { say, sayName } from '../words/say';

function figure(value: string, name: string): HTMLElement {
    return element('div', {}, element('dt', {}, name), element('dd', { class: 'number' }, value));
}

function noEvaluation(detail: string): HTMLElement {
    return emptyNotice(
        say('There is no report on this collection.'),
        say('A report needs at least two classes with two models each. Name the classes by'),
        ' ',
        element('code', {}, 'ossuary index --classes FILE.cla'),
        ` · ${detail}`,
    );
}

/** A line for each class and its measures. */
function classesCsv({ per_class }: Evaluation): string {
    return csv(Object.entries(per_class), [
        ['class', ([name]) => name],
        ['models', ([, { models }]) => models],
        ...kMetrics.map(
            ({ key }) => [key, ([, metrics]: [string, Metrics]) => metrics[key]] as const,
        ),
    ]);
}

/** The matrix as it is shown, a row for each class of queries. */
function confusionCsv({ confusion: { classes, values } }: Evaluation): string {
    return csv(
        classes.map((name, row) => ({ name, shares: values[row] ?? [] })),
        [
            ['class', ({ name }) => name],
            ...classes.map(
                (name, column) =>
                    [name, ({ shares }: { shares: number[] }) => shares[column] ?? 0] as const,
            ),
        ],
    );
}

function saveButton(name: string, text: () => string): HTMLElement {
    return element(
        'button',
        {
            type: 'button',
            class: 'link-button',
            'aria-label': `${say('Save as CSV')}: ${name}`,
            click: () => saveText(name, 'text/csv', text()),
        },
        say('Save as CSV'),
    );
}

/** Says that not all models were searched with. */
function sampleNote({ models, queries_total }: Evaluation): HTMLElement | null {
    return models >= queries_total
        ? null
        : element(
              'p',
              { class: 'fine' },
              say(
                  'A sample: {models} of {total} models were searched with, in all of them; the intervals say how far the figures may lie off.',
                  {
                      models: formatCount(models),
                      total: formatCount(queries_total),
                  },
              ),
          );
}

/** Detail of one ranker: figures by class and what is taken for what. */
function detail(evaluation: Evaluation, confused: ConfusedModels): HTMLElement[] {
    const { ranker } = evaluation;
    return [
        element(
            'section',
            { class: 'panel', 'aria-labelledby': 'classes-title' },
            element('h2', { id: 'classes-title' }, say('By class')),
            classTable(evaluation.per_class),
            saveButton(`classes-${ranker}.csv`, () => classesCsv(evaluation)),
        ),
        element(
            'section',
            { class: 'panel', 'aria-labelledby': 'confusion-title' },
            element('h2', { id: 'confusion-title' }, say('Confusion')),
            confusionMatrix(evaluation.confusion, (from, to) => void confused.show(from, to)),
            confused.node,
            saveButton(`confusion-${ranker}.csv`, () => confusionCsv(evaluation)),
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
        'aria-label': say('Ranker'),
    });
    private found_: readonly Evaluation[] = [];
    private chart_: CurveChart | null = null;
    private chosen_: Ranker | null = null;
    private readonly client_: Client;
    readonly sideBySide = element('section', {
        class: 'panel',
        'aria-labelledby': 'side-title',
        hidden: true,
    });
    private readonly running_ = new AbortController();
    private confused_: ConfusedModels | null = null;

    constructor(client: Client) {
        this.client_ = client;
        this.overview = element(
            'section',
            { class: 'panel', 'aria-labelledby': 'curve-title' },
            element('h2', { id: 'curve-title' }, say('Precision and recall')),
            this.curve_,
            this.metrics_,
        );
        this.detailHead = element(
            'div',
            { class: 'section-head', hidden: true },
            element('h2', {}, say('In detail')),
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
            figure(formatCount(first.models), say('models')),
            figure(formatCount(first.classes), say('classes')),
        ]);
        this.chart_?.dispose();
        this.chart_ = curveChart(found);
        this.curve_.classList.remove('curve-loading');
        replace(this.curve_, this.chart_.node);
        replace(this.metrics_, metricsTable(found), sampleNote(first));
        this.sideBySide.hidden = false;
        replace(
            this.sideBySide,
            element('h2', { id: 'side-title' }, say('Rankers side by side')),
            classBars(found),
            queryComparison(found, this.client_, this.running_.signal),
        );
        this.detailHead.hidden = false;
        const buttons = found.map(({ ranker }) =>
            element(
                'button',
                { type: 'button', value: ranker, click: () => this.choose(ranker) },
                capitalise(sayName(formatName(ranker))),
            ),
        );
        replace(this.choice_, buttons);
        this.choose(this.chosen_ ?? first.ranker);
    }

    dispose(): void {
        this.running_.abort();
        this.confused_?.dispose();
        this.chart_?.dispose();
    }

    private choose(ranker: Ranker): void {
        this.chosen_ = ranker;
        for (const button of this.choice_.querySelectorAll('button')) {
            button.setAttribute('aria-pressed', String(button.value === ranker));
        }
        const evaluation = this.found_.find((each) => each.ranker === ranker);
        if (evaluation) {
            this.confused_?.dispose();
            this.confused_ = new ConfusedModels(this.client_, ranker);
            replace(this.details, detail(evaluation, this.confused_));
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
        element('h1', {}, say('Reports')),
        element(
            'p',
            { class: 'lede' },
            say('Every model of the collection searches for the others of its class.'),
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
    const reports = new Reports(context.client);
    const progress = (next: Ranker, found: readonly Evaluation[]): void => {
        reports.show(found);
        const text = say('Evaluating {ranker}…', { ranker: sayName(formatName(next)) });
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
        context.announce(
            say('{reports} shown', { reports: formatPlural(found.length, 'report', 'reports') }),
        );
    };
    const ready = load();
    return {
        node: element(
            'div',
            { class: 'page reports' },
            element('div', { class: 'reports-head' }, introduction(), reports.figures),
            status,
            reports.overview,
            reports.sideBySide,
            reports.detailHead,
            reports.details,
        ),
        title: say('Reports'),
        ready,
        update: (route) => route.page === 'reports',
        dispose() {
            running.abort();
            reports.dispose();
        },
    };
}
