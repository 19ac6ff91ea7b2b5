import { isAbort } from '../api/problem';
import { type Child, element, replace } from '../page/element';
import { problemNotice } from '../page/problem_notice';
import { say } from '../words/say';

export interface DialogView {
    node: HTMLElement;
    dispose(): void;
}

export interface ViewerDialogOptions {
    title: Child;
    /** Between the title and the button that closes it. */
    actions: Child;
    /** Fetches and builds what is shown. */
    load: (signal: AbortSignal) => Promise<DialogView>;
    onClose: () => void;
    /** What keys do, but where a picture or a field takes them; null: nothing. */
    keys?: Readonly<Record<string, (() => void) | null>>;
}

export interface ViewerDialog {
    node: HTMLDialogElement;
    /** @param focused the id of what is to have the focus; the button that closes otherwise */
    open(focused?: string): void;
    dispose(): void;
}

/** The window over the hits; Escape and the browser's way back close it. */
export function viewerDialog(options: ViewerDialogOptions): ViewerDialog {
    const { title, actions, load, onClose, keys = {} } = options;
    const running = new AbortController();
    let view: DialogView | null = null;
    const body = element('div', { class: 'dialog-body', 'aria-busy': 'true' });
    const close = element(
        'button',
        { type: 'button', class: 'button button-icon', 'aria-label': say('Close'), click: onClose },
        '✕',
    );
    const node = element(
        'dialog',
        { class: 'viewer-dialog', 'aria-labelledby': 'dialog-title' },
        element(
            'div',
            { class: 'dialog-head' },
            element('h2', { id: 'dialog-title' }, title),
            element('div', { class: 'dialog-actions' }, actions, close),
        ),
        body,
    );
    const fill = async (): Promise<void> => {
        body.setAttribute('aria-busy', 'true');
        replace(body, element('div', { class: 'dialog-loading' }, say('Loading…')));
        try {
            const made = await load(running.signal);
            if (running.signal.aborted) {
                made.dispose();
                return;
            }
            view = made;
            replace(body, made.node);
        } catch (error) {
            if (!isAbort(error)) {
                replace(body, problemNotice(error, { retry: () => void fill() }));
            }
        } finally {
            body.removeAttribute('aria-busy');
        }
    };
    // Escape: the address changes first, and the dialog goes with it.
    node.addEventListener('cancel', (event) => {
        event.preventDefault();
        onClose();
    });
    node.addEventListener('keydown', (event) => {
        const press = keys[event.key];
        const taken = (event.target as Element).closest(
            'canvas, input, select, textarea, .joint-handle',
        );
        if (press && !taken && !event.altKey && !event.ctrlKey && !event.metaKey) {
            event.preventDefault();
            press();
        }
    });
    // A press on the backdrop arrives at the dialog itself.
    node.addEventListener('click', (event) => {
        if (event.target === node) {
            onClose();
        }
    });
    return {
        node,
        open(focused = '') {
            node.showModal();
            const wanted = focused === '' ? null : node.querySelector<HTMLElement>(`#${focused}`);
            (wanted ?? close).focus();
            void fill();
        },
        dispose() {
            running.abort();
            view?.dispose();
            node.close();
            node.remove();
        },
    };
}
