import type { Client } from '../api/client';
import type { PreviewMesh, QueryModel, UpAxis } from '../api/elements';
import type { Hit } from '../api/types';
import { element } from '../page/element';
import { formatDistance } from '../page/format';
import { formatRoute, partsOf, resultsOf } from '../page/routes';
import { partsList } from './parts_list';
import { type ViewerDialog, viewerDialog } from './viewer_dialog';

export interface ComparisonOptions {
    query: QueryModel;
    queryMesh: PreviewMesh | null;
    queryUp: UpAxis;
    hit: Hit;
    /** The comparison with the hit one rank better; null: there is none. */
    previousHref: string | null;
    nextHref: string | null;
    onClose: () => void;
}

function step(href: string | null, label: string, sign: string): HTMLElement {
    return href === null
        ? element('span', { class: 'button button-icon button-off', 'aria-hidden': 'true' }, sign)
        : element('a', { class: 'button button-icon', href, 'aria-label': label }, sign);
}

/** Query and hit side by side. */
export function comparisonDialog(options: ComparisonOptions, client: Client): ViewerDialog {
    const { query, queryMesh, queryUp, hit, previousHref, nextHref, onClose } = options;
    return viewerDialog({
        title: [
            element('span', {}, query.name),
            element('span', { class: 'versus', 'aria-label': 'and' }, '↔'),
            element('span', {}, hit.name),
            hit.class && element('span', { class: 'tag' }, hit.class),
        ],
        actions: [
            element(
                'span',
                { class: 'distance-figure' },
                'distance ',
                element('b', { class: 'number' }, formatDistance(hit.distance)),
            ),
            element(
                'a',
                { class: 'button', href: formatRoute(resultsOf({ kind: 'model', id: hit.id })) },
                'Find more like it',
            ),
            element('a', { class: 'button', href: formatRoute(partsOf(hit.id)) }, 'Its parts'),
            step(previousHref, 'Better hit', '←'),
            step(nextHref, 'Next hit', '→'),
        ],
        async load(signal) {
            const [{ comparison }, mesh, skeleton, { up, unit }] = await Promise.all([
                import('../viewer/comparison'),
                client.mesh(hit.id, signal),
                client.skeleton(hit.id, signal),
                client.model(hit.id, signal),
            ]);
            return comparison({
                query: {
                    name: query.name,
                    mesh: queryMesh,
                    skeleton: query.skeleton,
                    up: queryUp,
                    unit: query.unit,
                },
                hit: { name: hit.name, mesh, skeleton, up, unit },
                match: hit.match,
                note: partsList(hit.parts),
            });
        },
        onClose,
    });
}
