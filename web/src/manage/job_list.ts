import type { Administration, ListedJob } from '../api/administration';
import { isAbort } from '../api/problem';
import { element, replace } from '../page/element';
import { formatBytes } from '../page/format';
import { problemNotice } from '../page/problem_notice';
import { say, spokenLanguage } from '../words/say';
import { type JobState, jobStateLine } from './job_state';

/** Between looks: while something is on its way, and while nothing is. */
const kBusyMs = 2000;
const kIdleMs = 15_000;

function stateOf({ state, model, error }: ListedJob): JobState {
    if (state === 'done' && model !== null) {
        return { kind: 'done', model };
    }
    if (state === 'failed') {
        return { kind: 'failed', code: error?.code ?? '', message: error?.message ?? '' };
    }
    return { kind: state === 'running' ? 'running' : 'queued' };
}

function timeOf(moment: string): HTMLElement {
    const format = new Intl.DateTimeFormat(spokenLanguage(), {
        dateStyle: 'medium',
        timeStyle: 'short',
    });
    const time = new Date(moment);
    const text = Number.isNaN(time.getTime()) ? moment : format.format(time);
    return element('time', { datetime: moment }, text);
}

function row(job: ListedJob): HTMLElement {
    return element(
        'tr',
        {},
        element('th', { scope: 'row' }, job.name),
        element('td', {}, job.class ?? ''),
        element('td', { class: 'number' }, formatBytes(job.size)),
        element('td', {}, timeOf(job.accepted_at)),
        element('td', {}, jobStateLine(stateOf(job))),
    );
}

function table(jobs: readonly ListedJob[]): HTMLElement {
    const heads = [say('Name'), say('Class'), say('Size'), say('Accepted'), say('State')];
    return element(
        'div',
        // What can be scrolled can be reached with the keyboard.
        { class: 'table-scroll', tabindex: 0 },
        element(
            'table',
            { class: 'table' },
            element('caption', { class: 'visually-hidden' }, say('What was added')),
            element(
                'thead',
                {},
                element(
                    'tr',
                    {},
                    heads.map((head) => element('th', { scope: 'col' }, head)),
                ),
            ),
            element('tbody', {}, jobs.map(row)),
        ),
    );
}

/** What the server knows of the models that were added, here or by anybody else. */
export class JobList {
    readonly node = element('div', { class: 'jobs' });
    private readonly administration_: () => Administration;
    private readonly running_ = new AbortController();
    private timer_: ReturnType<typeof setTimeout> | undefined;
    /** What is shown: a table that changed under the hand would lose its place. */
    private shown_ = '';

    constructor(administration: () => Administration) {
        this.administration_ = administration;
    }

    /** Looks now, and again after a while. */
    async look(): Promise<void> {
        clearTimeout(this.timer_);
        const { signal } = this.running_;
        let pause = kIdleMs;
        try {
            const jobs = await this.administration_().jobs(signal);
            this.show(jobs);
            const busy = jobs.some(({ state }) => state === 'queued' || state === 'running');
            pause = busy ? kBusyMs : kIdleMs;
        } catch (error) {
            if (isAbort(error)) {
                return;
            }
            this.shown_ = '';
            replace(this.node, problemNotice(error, { retry: () => void this.look() }));
        }
        if (!signal.aborted) {
            clearTimeout(this.timer_);
            this.timer_ = setTimeout(() => void this.look(), pause);
        }
    }

    dispose(): void {
        clearTimeout(this.timer_);
        this.running_.abort();
    }

    private show(jobs: readonly ListedJob[]): void {
        const text = JSON.stringify(jobs);
        if (text === this.shown_) {
            return;
        }
        this.shown_ = text;
        replace(
            this.node,
            jobs.length === 0
                ? element('p', { class: 'fine' }, say('Nothing was added yet.'))
                : table(jobs),
        );
    }
}
