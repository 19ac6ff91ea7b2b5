import type { ModelSummary } from '../api/elements';
import { element } from '../page/element';
import { formatPlural } from '../page/format';
import { formatRoute, resultsOf } from '../page/routes';
import type { Selection } from '../page/selection';
import { placeLine } from './place_line';
import { selectCheck } from './select_check';
import { thumbnail } from './thumbnail';
import { say } from '../words/say';

/** A model of the collection; leads to what is similar to it. */
export function modelCard(model: ModelSummary, selection: Selection): HTMLElement {
    return element(
        'li',
        { class: 'card', 'data-model': model.id },
        element(
            'a',
            {
                class: 'card-link',
                href: formatRoute(resultsOf({ kind: 'model', id: model.id })),
                title: say('Find models like {name}', { name: model.name }),
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
        selectCheck(model, selection),
    );
}
