import type { ModelSummary } from '../api/elements';
import { element } from '../page/element';
import { formatPlural } from '../page/format';
import { formatRoute, resultsOf } from '../page/routes';
import { placeLine } from './place_line';
import { thumbnail } from './thumbnail';

/** A model of the collection; leads to what is similar to it. */
export function modelCard(model: ModelSummary): HTMLElement {
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
            thumbnail(model.links.thumbnail),
            element('span', { class: 'card-name' }, model.name),
            placeLine(model.path) ?? element('span', { class: 'card-file' }),
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
