import { partClass, partNames, partShares } from './distance_parts';
import { element } from '../page/element';
import { capitalise, formatDistance, formatName } from '../page/format';

/** The parts of a distance that count, each with its value and its share as a bar. */
export function partsList(parts: Readonly<Record<string, number>>): HTMLElement {
    return element(
        'dl',
        { class: 'parts-list', 'aria-label': 'Parts of the distance' },
        partShares(parts, partNames([{ parts }])).map(({ name, value, share }) =>
            element(
                'div',
                { class: partClass(name), '--share': share.toFixed(4) },
                element('dt', {}, capitalise(formatName(name))),
                element('dd', { class: 'number' }, formatDistance(value)),
            ),
        ),
    );
}
