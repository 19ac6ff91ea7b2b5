import { kUsualUp, type PreviewMesh, type QueryModel, type UpAxis } from '../api/elements';
import { isAbort } from '../api/problem';
import type { SearchParameters } from '../api/search_parameters';
import type { Hit, SearchResult } from '../api/types';
import type { Context, Page } from '../page/context';
import { element, replace } from '../page/element';
import { formatPlural } from '../page/format';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { formatRoute, kHome, partsOf, type Route, resultsOf, sameQuery } from '../page/routes';
import { comparisonDialog } from './comparison_dialog';
import { hitGrid } from './hit_grid';
import { partsDialog } from './parts_dialog';
import { queryPanel } from './query_panel';
import { type SearchForm, searchForm } from './search_form';
import { skeletonCards } from './thumbnail';
import { timingLine } from './timing_line';
import type { ViewerDialog } from './viewer_dialog';

type ResultsRoute = Extract<Route, { page: 'results' }>;

interface Answer {
    result: SearchResult;
    mesh: PreviewMesh | null;
    up: UpAxis;
}

function sameParameters(a: SearchParameters, b: SearchParameters): boolean {
    return (Object.keys(a) as (keyof SearchParameters)[]).every((name) => a[name] === b[name]);
}

/** Null: the upload is gone, since the page was loaded anew. */
async function ask(
    route: ResultsRoute,
    context: Context,
    signal: AbortSignal,
): Promise<Answer | null> {
    const { query, parameters } = route;
    if (query.kind === 'model') {
        const [result, mesh, { up }] = await Promise.all([
            context.client.similar(query.id, parameters, signal),
            context.client.mesh(query.id, signal),
            context.client.model(query.id, signal),
        ]);
        return { result, mesh, up: up ?? kUsualUp };
    }
    const { upload } = context;
    if (!upload) {
        return null;
    }
    const result = sameParameters(upload.parameters, parameters)
        ? upload.result
        : await context.client.search(upload.file, parameters, signal);
    context.upload = { file: upload.file, parameters, result };
    const { mesh, up = kUsualUp }: QueryModel = result.query;
    return { result, mesh: mesh ?? null, up };
}

/** What is similar to the query, and on top of it the 3D comparison with one hit. */
export function resultsPage(first: ResultsRoute, context: Context): Page {
    let route = first;
    let answer: Answer | null = null;
    let dialog: ViewerDialog | null = null;
    let panelShown = false;
    let running = new AbortController();
    const title = element('h1', { class: 'results-title' }, 'Searching…');
    const timing = element('div', {});
    const body = element('div', { class: 'results-body', 'aria-busy': 'true' });
    const panel = queryPanel();
    const makeForm = (parameters: SearchParameters): SearchForm =>
        searchForm(context.classes, {
            parameters,
            onChange: (changed) => context.navigate(resultsOf(route.query, changed)),
        });
    let form = makeForm(route.parameters);

    const hrefOf = (hit: Hit): string =>
        formatRoute(resultsOf(route.query, route.parameters, { kind: 'hit', id: hit.id }));
    const closeDialog = (): void => {
        const closed = dialog;
        dialog = null;
        closed?.dispose();
    };
    const backToHits = (): void => context.navigate(resultsOf(route.query, route.parameters));
    const hitDialog = ({ result, mesh, up }: Answer, id: number): ViewerDialog | null => {
        const { hits, query } = result;
        const place = hits.findIndex((hit) => hit.id === id);
        const hit = hits[place];
        if (!hit) {
            return null;
        }
        const before = hits[place - 1];
        const after = hits[place + 1];
        return comparisonDialog(
            {
                query,
                queryMesh: mesh,
                queryUp: up,
                hit,
                previousHref: before ? hrefOf(before) : null,
                nextHref: after ? hrefOf(after) : null,
                onClose: backToHits,
            },
            context.client,
        );
    };
    const openDialog = (): void => {
        closeDialog();
        if (!answer || route.over === null) {
            return;
        }
        if (route.over.kind === 'hit') {
            dialog = hitDialog(answer, route.over.id);
        } else if (route.query.kind === 'model') {
            const { query } = answer.result;
            dialog = partsDialog(
                { id: route.query.id, query, up: answer.up, onClose: backToHits },
                context.client,
            );
        }
        if (!dialog) {
            backToHits();
            return;
        }
        document.body.append(dialog.node);
        dialog.open();
    };
    const show = (found: Answer): void => {
        answer = found;
        const { result } = found;
        replace(title, 'Models like ', element('em', {}, result.query.name));
        replace(timing, timingLine(result));
        context.classes.add(result.hits.map((hit) => hit.class));
        replace(
            body,
            result.hits.length > 0
                ? hitGrid(result.hits, hrefOf)
                : emptyNotice('No hits.', 'No other model of the collection fits the options.'),
        );
        context.announce(`${formatPlural(result.hits.length, 'hit')} for ${result.query.name}`);
        if (!panelShown) {
            // The query stays the same whatever it is asked for.
            panelShown = true;
            const { query } = route;
            const partsHref =
                query.kind === 'model' ? formatRoute(partsOf(query.id, route.parameters)) : null;
            void panel.show(result.query, { mesh: found.mesh, up: found.up, partsHref });
        }
        openDialog();
    };
    const load = async (): Promise<void> => {
        running.abort();
        running = new AbortController();
        const { signal } = running;
        answer = null;
        replace(body, element('ul', { class: 'grid' }, skeletonCards(12)));
        body.setAttribute('aria-busy', 'true');
        try {
            const found = await ask(route, context, signal);
            if (found) {
                show(found);
                return;
            }
            title.textContent = 'No query';
            replace(
                body,
                emptyNotice(
                    'The uploaded model is gone.',
                    'It is kept only until the page is loaded anew. ',
                    element('a', { href: formatRoute(kHome) }, 'Choose a model again'),
                ),
            );
            page.node.classList.add('results-without-query');
        } catch (error) {
            if (!isAbort(error)) {
                title.textContent = 'The search failed';
                replace(body, problemNotice(error, { retry: () => void load() }));
            }
        } finally {
            if (!signal.aborted) {
                body.removeAttribute('aria-busy');
            }
        }
    };

    const page: Page = {
        node: element(
            'div',
            { class: 'page results' },
            element(
                'aside',
                { class: 'results-side' },
                panel.node,
                element(
                    'details',
                    { class: 'options', open: matchMedia('(min-width: 60rem)').matches },
                    element('summary', {}, 'Search options'),
                    form.node,
                ),
            ),
            element(
                'div',
                { class: 'results-main' },
                element('div', { class: 'results-head' }, title, timing),
                body,
            ),
        ),
        title: 'Results',
        update(next) {
            if (next.page !== 'results' || !sameQuery(next.query, route.query)) {
                return false;
            }
            const asked = sameParameters(next.parameters, route.parameters);
            route = next;
            if (asked) {
                openDialog();
                return true;
            }
            if (!sameParameters(form.parameters, next.parameters)) {
                // By the browser's way back: the form did not bring the change about.
                form.dispose();
                const made = makeForm(next.parameters);
                form.node.replaceWith(made.node);
                form = made;
            }
            closeDialog();
            void load();
            return true;
        },
        dispose() {
            running.abort();
            closeDialog();
            panel.dispose();
            form.dispose();
        },
    };
    void load();
    return page;
}
