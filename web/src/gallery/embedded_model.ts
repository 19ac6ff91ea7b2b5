import type { Client } from '../api/client';
import { codePart } from '../page/code_part';
import { element, replace } from '../page/element';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { formatRoute, lookAt, parseRoute } from '../page/routes';
import { say } from '../words/say';

let shown: { dispose(): void } | null = null;

/**
 * One model of the collection that fills `root`, for a frame in another page; its name leads to the
 * gallery. `#/models/7` in the address says which.
 */
export async function embeddedModel(
    root: HTMLElement,
    hash: string,
    client: Client,
): Promise<void> {
    shown?.dispose();
    shown = null;
    const route = parseRoute(hash);
    if (route.page !== 'results' || route.query.kind !== 'model') {
        replace(
            root,
            emptyNotice(say('No model is named.'), say('The address ends with'), ' #/models/7'),
        );
        return;
    }
    const held = route.query;
    try {
        const [{ queryView }, { name, up }, mesh, skeleton] = await Promise.all([
            codePart(() => import('../viewer/query_view')),
            client.model(held.id),
            client.mesh(held),
            client.skeleton(held),
        ]);
        const view = queryView({ name, mesh, skeleton, up });
        shown = view;
        const href = `/${formatRoute(lookAt(held))}`;
        const link = element(
            'a',
            { class: 'embed-name', href, target: '_blank', rel: 'noopener' },
            name,
        );
        replace(root, element('h1', { class: 'visually-hidden' }, name), view.node, link);
        document.title = `${name} · Ossuary`;
    } catch (error) {
        const retry = (): void => void embeddedModel(root, hash, client);
        replace(root, problemNotice(error, { retry }));
    }
}
