import { partClass, partNames, partShares } from './distance_parts';
import { element } from '../page/element';
import { capitalise, formatDistance, formatName } from '../page/format';
import { say, sayName } from '../words/say';

/** The parts of a distance that count, each with its value and its share as a bar. */
export function partsList(parts: Readonly<Record<string, number>>): HTMLElement {
    return element(
        'dl',
        { class: 'parts-list', 'aria-label': say('Parts of the distance') },
        partShares(parts, partNames([{ parts }])).map(({ name, value, share }) =>
            element(
                'div',
                { class: partClass(name), '--share': share.toFixed(4) },
                element('dt', {}, capitalise(sayName(formatName(name)))),
                element('dd', { class: 'number' }, formatDistance(value)),
            ),
        ),
    );
}
