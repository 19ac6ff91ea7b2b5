import type { Hit } from '../api/types';
import { element } from '../page/element';
import { formatDistance } from '../page/format';
import { differenceBars, type LikeHit, likeHitLinks } from './build_and_pose';
import { partsBar } from './distance_parts';
import { thumbnail } from './thumbnail';

export interface HitCardOptions {
    /** Where the 3D comparison with the query is. */
    href: string;
    /** Where searches from the hit itself are. */
    like: LikeHit;
    partNames: readonly string[];
    /** The distance that fills the bar. */
    longest: number;
}

export function hitCard(hit: Hit, options: HitCardOptions): HTMLElement {
    const length = options.longest > 0 ? hit.distance / options.longest : 0;
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
            thumbnail(hit.id),
            element('span', { class: 'card-name' }, hit.name),
            element(
                'span',
                { class: 'card-line' },
                hit.class ? element('span', { class: 'tag' }, hit.class) : element('span', {}),
                element(
                    'span',
                    { class: 'number', title: 'Distance' },
                    element('span', { class: 'visually-hidden' }, 'Distance '),
                    formatDistance(hit.distance),
                ),
            ),
            partsBar(hit.parts, options.partNames, length),
            differenceBars(hit),
        ),
        likeHitLinks(hit, options.like),
    );
}
