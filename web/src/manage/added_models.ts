import type { Administration } from '../api/administration';
import { ApiError, isAbort } from '../api/problem';
import { element, replace } from '../page/element';
import { problemNotice } from '../page/problem_notice';
import { say } from '../words/say';
import { type JobState, jobStateLine } from './job_state';

const kPollMs = 500;

function pause(signal: AbortSignal): Promise<void> {
    return new Promise((resolve) => {
        const timer = setTimeout(resolve, kPollMs);
        signal.addEventListener('abort', () => {
            clearTimeout(timer);
            resolve();
        });
    });
}

/** Files on their way into the collection, one after the other, with their jobs. */
export class AddedModels {
    readonly node = element('ol', { class: 'added-models' });
    private readonly administration_: () => Administration;
    private readonly onAdded_: () => void;
    private readonly running_ = new AbortController();
    private last_: Promise<void> = Promise.resolve();

    constructor(administration: () => Administration, onAdded: () => void) {
        this.administration_ = administration;
        this.onAdded_ = onAdded;
    }

    add(files: readonly File[], className: string): void {
        for (const file of files) {
            const line = element('span', { class: 'added-state' }, say('waiting'));
            this.node.append(element('li', {}, element('b', {}, file.name), ' ', line));
            // One upload at a time: the server takes a few at once, and each is to get through.
            this.last_ = this.last_.then(() => this.send(file, className, line));
        }
    }

    dispose(): void {
        this.running_.abort();
    }

    private async send(file: File, className: string, line: HTMLElement): Promise<void> {
        const { signal } = this.running_;
        const show = (state: JobState): void => replace(line, jobStateLine(state));
        try {
            const onSent = (share: number): void => show({ kind: 'sending', share });
            const job = await this.administration_().add(file, className, onSent, signal);
            void this.follow(job, show);
        } catch (error) {
            this.fail(error, line);
        }
    }

    private async follow(id: number, show: (state: JobState) => void): Promise<void> {
        const { signal } = this.running_;
        while (!signal.aborted) {
            try {
                const { state, model, error } = await this.administration_().job(id, signal);
                if (state === 'done' && model !== null) {
                    show({ kind: 'done', model });
                    this.onAdded_();
                    return;
                }
                if (state === 'failed') {
                    show({
                        kind: 'failed',
                        code: error?.code ?? '',
                        message: error?.message ?? '',
                    });
                    return;
                }
                show({ kind: state === 'running' ? 'running' : 'queued' });
            } catch (error) {
                if (isAbort(error)) {
                    return;
                }
                // The server is away for a while; the job waits in the index.
            }
            await pause(signal);
        }
    }

    private fail(error: unknown, line: HTMLElement): void {
        if (isAbort(error)) {
            return;
        }
        if (error instanceof ApiError) {
            replace(
                line,
                jobStateLine({ kind: 'failed', code: error.code, message: error.message }),
            );
        } else {
            replace(line, problemNotice(error));
        }
    }
}
