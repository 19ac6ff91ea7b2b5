import type { PreviewMesh, QueryModel, UpAxis } from '../api/elements';
import { codePart } from '../page/code_part';
import { element, replace } from '../page/element';
import { formatCount, formatSize } from '../page/format';
import { say } from '../words/say';
import { problemNotice } from '../page/problem_notice';

export interface QueryPanelOptions {
    /** Null: the skeleton alone. */
    mesh: PreviewMesh | null;
    up: UpAxis;
    /** Where the query's parts are shown; null: nowhere, since the server does not keep it. */
    partsHref: string | null;
    lookHref: string;
    /** What of it can be saved; null: nothing. */
    takeAway: HTMLElement | null;
}

export interface QueryPanel {
    node: HTMLElement;
    /** Shows the query in 3D. */
    show(query: QueryModel, options: QueryPanelOptions): Promise<void>;
    dispose(): void;
}

function facts(query: QueryModel, mesh: PreviewMesh | null): HTMLElement {
    const rows: [string, string][] = [
        [say('Vertices'), formatCount(query.vertices)],
        [say('Faces'), formatCount(query.faces)],
        [say('Branches'), formatCount(query.skeleton.branches.length)],
        [say('Nodes'), formatCount(query.skeleton.nodes.length)],
    ];
    if (mesh) {
        rows.push([say('Size'), formatSize(mesh.bounds, query.unit)]);
    }
    return element(
        'dl',
        { class: 'facts' },
        rows.map(([name, value]) =>
            element('div', {}, element('dt', {}, name), element('dd', { class: 'number' }, value)),
        ),
    );
}

function warnings(query: QueryModel): HTMLElement | null {
    return query.warnings.length === 0
        ? null
        : element(
              'details',
              { class: 'warnings' },
              element(
                  'summary',
                  {},
                  say('Notes on the mesh ({count})', { count: query.warnings.length }),
              ),
              element(
                  'ul',
                  {},
                  query.warnings.map((warning) => element('li', {}, warning.message)),
              ),
          );
}

/** The query beside its hits: picture, name, figures. */
export function queryPanel(): QueryPanel {
    const picture = element('div', { class: 'query-picture', 'aria-busy': 'true' });
    const text = element('div', { class: 'query-text' });
    let pane: { dispose(): void } | null = null;
    let disposed = false;
    return {
        node: element('section', { class: 'query', 'aria-label': say('The query') }, picture, text),
        async show(query, { mesh, up, partsHref, lookHref, takeAway }) {
            const parts =
                partsHref !== null &&
                element('a', { class: 'button', href: partsHref }, say('Parts and pose'));
            const look = element('a', { class: 'button', href: lookHref }, say('Look closer'));
            const ways = element('div', { class: 'query-ways' }, look, parts);
            replace(text, facts(query, mesh), ways, takeAway, warnings(query));
            try {
                // three.js is fetched only where something is drawn with it.
                const { queryView } = await codePart(() => import('../viewer/query_view'));
                if (disposed) {
                    return;
                }
                pane?.dispose();
                const view = queryView({ name: query.name, skeleton: query.skeleton, mesh, up });
                pane = view;
                replace(picture, view.node);
            } catch (error) {
                replace(picture, problemNotice(error, { retry: () => location.reload() }));
            } finally {
                picture.removeAttribute('aria-busy');
            }
        },
        dispose() {
            disposed = true;
            pane?.dispose();
        },
    };
}
