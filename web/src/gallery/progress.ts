import { element } from '../page/element';
import { formatDuration } from '../page/format';
import { say } from '../words/say';

export interface ProgressOptions {
    message: string;
    onCancel: () => void;
}

const kDefaults: ProgressOptions = { message: '', onCancel: () => {} };
const kTickMs = 100;

export interface Progress {
    node: HTMLElement;
    /** What is being done; with a share the bar says how much of it is. */
    stage(message: string, share: number | null): void;
    dispose(): void;
}

/** A bar and the time so far; without an end where nobody says how far it is. */
export function progress(options: Partial<ProgressOptions> = {}): Progress {
    const { message, onCancel } = { ...kDefaults, ...options };
    const said = element('span', {}, message);
    const bar = element('div', {
        class: 'progress-bar',
        role: 'progressbar',
        'aria-label': message,
    });
    const elapsed = element('span', { class: 'number', 'aria-hidden': 'true' }, '0.0 s');
    const started = performance.now();
    const timer = setInterval(() => {
        const time = performance.now() - started;
        elapsed.textContent =
            time < 10_000 ? `${(time / 1000).toFixed(1)} s` : formatDuration(time);
    }, kTickMs);
    return {
        node: element(
            'div',
            { class: 'progress' },
            element(
                'div',
                { class: 'progress-line' },
                said,
                elapsed,
                element(
                    'button',
                    { type: 'button', class: 'button button-quiet', click: onCancel },
                    say('Cancel'),
                ),
            ),
            bar,
        ),
        stage(text, share) {
            said.textContent = text;
            bar.setAttribute('aria-valuetext', text);
            bar.classList.toggle('progress-known', share !== null);
            if (share === null) {
                bar.removeAttribute('aria-valuenow');
            } else {
                bar.setAttribute('aria-valuenow', String(Math.round(100 * share)));
                bar.style.setProperty('--share', share.toFixed(3));
            }
        },
        dispose: () => clearInterval(timer),
    };
}
