import type { Context } from '../page/context';
import { element, replace } from '../page/element';
import { formatBytes } from '../page/format';
import { problemNotice } from '../page/problem_notice';
import { formatRoute, resultsOf } from '../page/routes';
import type { Upload } from '../page/uploads';
import { type Progress, progress } from './progress';
import { say } from '../words/say';

export interface UploadTray {
    node: HTMLElement;
    /** Says what was wrong before there was an upload. */
    complain(error: unknown): void;
    dispose(): void;
}

function addressOf({ token, answer }: Upload): string {
    return formatRoute(
        resultsOf(
            token === null ? { kind: 'upload' } : { kind: 'query', token },
            answer?.parameters,
        ),
    );
}

function closeButton(label: string, onClick: () => void): HTMLElement {
    return element(
        'button',
        { type: 'button', class: 'chip-close', 'aria-label': label, click: onClick },
        '✕',
    );
}

function complaint(error: unknown, name: string, onClose: () => void): HTMLElement {
    return element(
        'div',
        { class: 'upload-problem' },
        problemNotice(error),
        closeButton(say('Close: {name}', { name }), onClose),
    );
}

/** The files of this session: what runs, what failed, and the way back to those that are done. */
class Tray implements UploadTray {
    readonly node = element('section', {
        class: 'uploads',
        'aria-label': say('Searches with files'),
    });
    private readonly chips_ = element('ul', { class: 'upload-chips' });
    private readonly bars_ = element('div', { class: 'upload-bars' });
    private readonly complaints_ = element('div', { class: 'upload-problems' });
    private readonly context_: Context;
    private readonly end_: () => void;
    private bar_: { upload: Upload; progress: Progress; stop?: AbortController } | null = null;
    private readonly said_ = new Map<Upload, HTMLElement>();

    constructor(context: Context) {
        this.context_ = context;
        this.node.append(this.chips_, this.bars_, this.complaints_);
        this.end_ = context.uploads.subscribe(() => this.show());
        context.uploads.onSent = (upload) => this.sent(upload);
        this.show();
    }

    complain(error: unknown): void {
        const notice = complaint(error, 'the problem', () => {
            notice.remove();
            this.fold();
        });
        this.complaints_.append(notice);
        this.fold();
    }

    dispose(): void {
        this.end_();
        this.endBar();
    }

    private endBar(): void {
        this.bar_?.progress.dispose();
        this.bar_?.stop?.abort();
        this.bar_ = null;
    }

    private show(): void {
        const { list } = this.context_.uploads;
        this.follow(list.find(({ state }) => state === 'running') ?? null);
        const chips = list.filter(({ state }) => state === 'done' || state === 'waiting');
        // One alone is what the page shows anyway.
        replace(this.chips_, chips.length > 1 ? chips.map((upload) => this.chip(upload)) : null);
        for (const [upload, notice] of this.said_) {
            if (!list.includes(upload)) {
                notice.remove();
                this.said_.delete(upload);
            }
        }
        for (const upload of list) {
            if (upload.state === 'failed' && !this.said_.has(upload)) {
                const remove = (): void => this.context_.uploads.remove(upload);
                const notice = complaint(upload.error, upload.name, remove);
                this.said_.set(upload, notice);
                this.complaints_.append(notice);
            }
        }
        this.fold();
    }

    private chip(upload: Upload): HTMLElement {
        const remove = closeButton(say('Forget {name}', { name: upload.name }), () =>
            this.context_.uploads.remove(upload),
        );
        return element(
            'li',
            { class: 'chip' },
            upload.state === 'done'
                ? element('a', { href: addressOf(upload) }, upload.name)
                : element('span', {}, upload.name, ' ', element('span', {}, say('waiting'))),
            remove,
        );
    }

    private follow(upload: Upload | null): void {
        if (upload === (this.bar_?.upload ?? null)) {
            return;
        }
        this.endBar();
        if (upload) {
            const size = upload.size === null ? '' : ` (${formatBytes(upload.size)})`;
            const bar = progress({
                message: say('Searching with {name}', { name: `${upload.name}${size}` }),
                onCancel: () => this.context_.uploads.remove(upload),
            });
            this.context_.announce(say('Searching with {name}', { name: upload.name }));
            this.bar_ = { upload, progress: bar };
        }
        replace(this.bars_, this.bar_?.progress.node);
    }

    private sent(upload: Upload): void {
        if (this.bar_?.upload !== upload) {
            return;
        }
        const share = upload.sent ?? 0;
        const done = share >= 1;
        this.bar_.progress.stage(
            done
                ? `${upload.name}: ${say('The server reads it, finds its skeleton and ranks the collection')}`
                : `${say('Sending {name}', { name: upload.name })} (${Math.round(100 * share)} %)`,
            done ? null : share,
        );
        if (done) {
            void this.followStages(this.bar_);
        }
    }

    private async followStages(bar: NonNullable<Tray['bar_']>): Promise<void> {
        const { upload, progress: shown } = bar;
        if (bar.stop || !upload.progress) {
            return;
        }
        bar.stop = new AbortController();
        const { signal } = bar.stop;
        try {
            const { followStages, nameOfStage } = await import('./search_stages');
            await followStages(
                this.context_.client,
                upload.progress,
                (stage) => shown.stage(`${upload.name}: ${nameOfStage(stage)}`, null),
                signal,
            );
        } catch {
            // Without that code the bar says less.
        }
    }

    private fold(): void {
        this.node.hidden = [this.chips_, this.bars_, this.complaints_].every(
            ({ childElementCount }) => childElementCount === 0,
        );
    }
}

export function uploadTray(context: Context): UploadTray {
    return new Tray(context);
}
