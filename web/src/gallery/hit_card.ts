import type { Hit } from '../api/types';
import { element } from '../page/element';
import { formatCount, formatDistance, formatPlural } from '../page/format';
import type { Selection } from '../page/selection';
import { differenceBars, type LikeHit, likeHitLinks } from './build_and_pose';
import { partsBar } from './distance_parts';
import { kNearnessMeanings, kUsualDistance, type Nearness } from './nearness';
import { placeLine } from './place_line';
import { selectCheck } from './select_check';
import { thumbnail } from './thumbnail';
import { say } from '../words/say';

export interface HitCardOptions {
    /** Where the 3D comparison with the query is. */
    href: string;
    /** Where searches from the hit itself are. */
    like: LikeHit;
    partNames: readonly string[];
    nearness: Nearness | null;
    selection: Selection;
}

/** How many models this one stands for. */
function copiesOf({ copies }: Hit): HTMLElement {
    return element(
        'span',
        {
            class: 'card-copies',
            title: say('{copies} of it in the collection', {
                copies: formatPlural(copies, 'copy', 'copies'),
            }),
        },
        ` ×${formatCount(copies + 1)}`,
    );
}

export function hitCard(hit: Hit, options: HitCardOptions): HTMLElement {
    const { nearness } = options;
    const figure = formatDistance(hit.distance);
    return element(
        'li',
        { class: 'card hit-card', 'data-model': hit.id },
        element(
            'a',
            { class: 'card-link', href: options.href, 'data-hit': hit.id },
            element(
                'span',
                { class: 'card-rank' },
                element('span', { class: 'visually-hidden' }, say('Rank'), ' '),
                hit.rank,
            ),
            thumbnail(hit.thumbnail),
            element('span', { class: 'card-name' }, hit.name, hit.copies > 0 && copiesOf(hit)),
            placeLine(hit.path),
            element(
                'span',
                { class: 'card-line' },
                hit.class ? element('span', { class: 'tag' }, hit.class) : element('span', {}),
                element(
                    'span',
                    {
                        class: 'number',
                        title: nearness
                            ? `${say('Distance')} ${figure}. ${say(kNearnessMeanings[nearness])}`
                            : say('Distance'),
                    },
                    element('span', { class: 'visually-hidden' }, say('Distance'), ' '),
                    nearness ? say(nearness) : figure,
                ),
            ),
            partsBar(hit.parts, options.partNames, hit.distance / kUsualDistance),
            differenceBars(hit),
        ),
        selectCheck(hit, options.selection),
        likeHitLinks(hit, options.like),
    );
}
