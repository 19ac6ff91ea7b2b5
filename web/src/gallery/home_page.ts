import { isAbort } from '../api/problem';
import type { Context, Page } from '../page/context';
import { element, replace } from '../page/element';
import { formatBytes, formatPlural } from '../page/format';
import { problemNotice } from '../page/problem_notice';
import { type Route, resultsOf } from '../page/routes';
import { collection } from './collection';
import { dropZone } from './drop_zone';
import { progress } from './progress';
import { searchForm } from './search_form';

/** Where one starts: drop a model, or pick one of the collection. */
export function homePage(route: Extract<Route, { page: 'home' }>, context: Context): Page {
    let running = new AbortController();
    const message = element('div', { class: 'home-message' });
    const zone = dropZone({ onFile: (file) => void search(file) });
    const form = searchForm(context.classes);
    const models = collection(route, context);

    async function search(file: File): Promise<void> {
        const { parameters } = form;
        running = new AbortController();
        const bar = progress({
            message: `Searching with ${file.name} (${formatBytes(file.size)})`,
            onCancel: () => running.abort(),
        });
        replace(message, bar.node);
        zone.busy = true;
        context.announce(`Searching with ${file.name}`);
        try {
            const result = await context.client.search(file, parameters, running.signal);
            context.upload = { file, parameters, result };
            context.announce(`${formatPlural(result.hits.length, 'hit')} for ${file.name}`);
            context.navigate(resultsOf({ kind: 'upload' }, parameters));
        } catch (error) {
            message.replaceChildren();
            if (!isAbort(error)) {
                replace(message, problemNotice(error));
            }
        } finally {
            bar.dispose();
            zone.busy = false;
        }
    }

    return {
        node: element(
            'div',
            { class: 'page home' },
            element(
                'section',
                { class: 'hero' },
                element(
                    'div',
                    { class: 'hero-text' },
                    element('h1', {}, 'Find models that are built like this one.'),
                    element(
                        'p',
                        { class: 'lede' },
                        'Each model is thinned to its skeleton. Two models are alike when their skeletons can be laid over each other, branch by branch.',
                    ),
                    element(
                        'details',
                        { class: 'options' },
                        element('summary', {}, 'Search options'),
                        form.node,
                    ),
                ),
                element('div', { class: 'hero-drop' }, zone.node, message),
            ),
            models.node,
        ),
        title: 'Search',
        update(next) {
            if (next.page !== 'home') {
                return false;
            }
            models.show(next);
            return true;
        },
        dispose() {
            running.abort();
            zone.dispose();
            form.dispose();
            models.dispose();
        },
    };
}
