import type { ModelSummary } from '../api/elements';
import { element } from '../page/element';
import { formatPlural } from '../page/format';
import { formatRoute, resultsOf } from '../page/routes';
import { sharedFileOf } from './shared_file';
import { thumbnail } from './thumbnail';

/** A model of the collection; leads to what is similar to it. */
export function modelCard(model: ModelSummary): HTMLElement {
    const shared = sharedFileOf(model.path);
    return element(
        'li',
        { class: 'card' },
        element(
            'a',
            {
                class: 'card-link',
                href: formatRoute(resultsOf({ kind: 'model', id: model.id })),
                title: `Find models like ${model.name}`,
            },
            thumbnail(model.id),
            element('span', { class: 'card-name' }, model.name),
            shared &&
                element('span', { class: 'fine card-file', title: model.path }, `in ${shared}`),
            element(
                'span',
                { class: 'card-line' },
                model.class && element('span', { class: 'tag' }, model.class),
                element(
                    'span',
                    { class: 'fine' },
                    formatPlural(model.branches, 'branch', 'branches'),
                ),
            ),
        ),
    );
}
