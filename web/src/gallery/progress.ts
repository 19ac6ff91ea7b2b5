import { element } from '../page/element';
import { formatDuration } from '../page/format';

export interface ProgressOptions {
    message: string;
    onCancel: () => void;
}

const kDefaults: ProgressOptions = { message: 'Searching', onCancel: () => {} };
const kTickMs = 100;

export interface Progress {
    node: HTMLElement;
    dispose(): void;
}

/** A bar without an end, because the server does not say how far it is, and the time so far. */
export function progress(options: Partial<ProgressOptions> = {}): Progress {
    const { message, onCancel } = { ...kDefaults, ...options };
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
                element('span', {}, message),
                elapsed,
                element(
                    'button',
                    { type: 'button', class: 'button button-quiet', click: onCancel },
                    'Cancel',
                ),
            ),
            element('div', {
                class: 'progress-bar',
                role: 'progressbar',
                'aria-label': message,
            }),
        ),
        dispose: () => clearInterval(timer),
    };
}
