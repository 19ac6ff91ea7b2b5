import type { Hit } from '../api/types';
import { element } from '../page/element';
import { formatCount, formatDistance, formatPlural } from '../page/format';
import { differenceBars, type LikeHit, likeHitLinks } from './build_and_pose';
import { partsBar } from './distance_parts';
import { kNearnessMeanings, kUsualDistance, type Nearness } from './nearness';
import { placeLine } from './place_line';
import { thumbnail } from './thumbnail';

export interface HitCardOptions {
    /** Where the 3D comparison with the query is. */
    href: string;
    /** Where searches from the hit itself are. */
    like: LikeHit;
    partNames: readonly string[];
    nearness: Nearness | null;
}

/** How many models this one stands for. */
function copiesOf({ copies }: Hit): HTMLElement {
    return element(
        'span',
        {
            class: 'card-copies',
            title: `${formatPlural(copies, 'copy', 'copies')} of it in the collection`,
        },
        ` ×${formatCount(copies + 1)}`,
    );
}

export function hitCard(hit: Hit, options: HitCardOptions): HTMLElement {
    const { nearness } = options;
    const figure = formatDistance(hit.distance);
    return element(
        'li',
        { class: 'card hit-card' },
        element(
            'a',
            { class: 'card-link', href: options.href, 'data-hit': hit.id },
            element(
                'span',
                { class: 'card-rank' },
                element('span', { class: 'visually-hidden' }, 'Rank '),
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
                            ? `Distance ${figure}. ${kNearnessMeanings[nearness]}`
                            : 'Distance',
                    },
                    element('span', { class: 'visually-hidden' }, 'Distance '),
                    nearness ?? figure,
                ),
            ),
            partsBar(hit.parts, options.partNames, hit.distance / kUsualDistance),
            differenceBars(hit),
        ),
        likeHitLinks(hit, options.like),
    );
}
