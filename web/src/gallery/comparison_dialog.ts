import type { Client } from '../api/client';
import { isAbort } from '../api/problem';
import type { Hit, PreviewMesh, QueryModel } from '../api/types';
import { element, replace } from '../page/element';
import { formatDistance } from '../page/format';
import { problemNotice } from '../page/problem_notice';
import { formatRoute, resultsOf } from '../page/routes';

export interface ComparisonOptions {
    query: QueryModel;
    queryMesh: PreviewMesh | null;
    hit: Hit;
    /** The comparison with the hit one rank better; null: there is none. */
    previousHref: string | null;
    nextHref: string | null;
    onClose: () => void;
}

export interface ComparisonDialog {
    node: HTMLDialogElement;
    open(): void;
    dispose(): void;
}

function step(href: string | null, label: string, sign: string): HTMLElement {
    return href === null
        ? element('span', { class: 'button button-icon button-off', 'aria-hidden': 'true' }, sign)
        : element('a', { class: 'button button-icon', href, 'aria-label': label }, sign);
}

/** The window over the hits; Escape and the browser's way back close it. */
export function comparisonDialog(options: ComparisonOptions, client: Client): ComparisonDialog {
    const { query, queryMesh, hit, previousHref, nextHref, onClose } = options;
    const running = new AbortController();
    let view: { dispose(): void } | null = null;
    const body = element('div', { class: 'comparison-body', 'aria-busy': 'true' });
    const close = element(
        'button',
        { type: 'button', class: 'button button-icon', 'aria-label': 'Close', click: onClose },
        '✕',
    );
    const node = element(
        'dialog',
        { class: 'comparison', 'aria-labelledby': 'comparison-title' },
        element(
            'div',
            { class: 'comparison-head' },
            element(
                'h2',
                { id: 'comparison-title' },
                element('span', {}, query.name),
                element('span', { class: 'versus', 'aria-label': 'and' }, '↔'),
                element('span', {}, hit.name),
                hit.class && element('span', { class: 'tag' }, hit.class),
            ),
            element(
                'div',
                { class: 'comparison-actions' },
                element(
                    'span',
                    { class: 'distance-figure' },
                    'distance ',
                    element('b', { class: 'number' }, formatDistance(hit.distance)),
                ),
                element(
                    'a',
                    {
                        class: 'button',
                        href: formatRoute(resultsOf({ kind: 'model', id: hit.id })),
                    },
                    'Find more like it',
                ),
                step(previousHref, 'Better hit', '←'),
                step(nextHref, 'Next hit', '→'),
                close,
            ),
        ),
        body,
    );
    const load = async (): Promise<void> => {
        replace(body, element('div', { class: 'comparison-loading' }, 'Loading the models…'));
        try {
            const [{ comparison }, hitMesh, hitSkeleton] = await Promise.all([
                import('../viewer/comparison'),
                client.mesh(hit.id, running.signal),
                client.skeleton(hit.id, running.signal),
            ]);
            if (running.signal.aborted) {
                return;
            }
            const made = comparison({
                query: { name: query.name, mesh: queryMesh, skeleton: query.skeleton },
                hit: { name: hit.name, mesh: hitMesh, skeleton: hitSkeleton },
                match: hit.match,
                parts: hit.parts,
            });
            view = made;
            replace(body, made.node);
        } catch (error) {
            if (!isAbort(error)) {
                replace(body, problemNotice(error, { retry: () => void load() }));
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
    // A press on the backdrop arrives at the dialog itself.
    node.addEventListener('click', (event) => {
        if (event.target === node) {
            onClose();
        }
    });
    return {
        node,
        open() {
            node.showModal();
            close.focus();
            void load();
        },
        dispose() {
            running.abort();
            view?.dispose();
            node.close();
            node.remove();
        },
    };
}
