import type { Hit } from '../api/types';
import { element } from '../page/element';
import type { LikeHit } from './build_and_pose';
import { partNames, partsLegend } from './distance_parts';
import { hitCard } from './hit_card';

/** All hits, best first, with what the colours of their bars mean. */
export function hitGrid(
    hits: readonly Hit[],
    hrefOf: (hit: Hit) => string,
    likeOf: (hit: Hit) => LikeHit,
): HTMLElement {
    const names = partNames(hits);
    const longest = Math.max(0, ...hits.map((hit) => hit.distance).filter(Number.isFinite));
    return element(
        'div',
        { class: 'hits' },
        partsLegend(names),
        element(
            'ol',
            { class: 'grid', 'aria-label': 'Hits, most similar first' },
            hits.map((hit) =>
                hitCard(hit, {
                    href: hrefOf(hit),
                    like: likeOf(hit),
                    partNames: names,
                    longest,
                }),
            ),
        ),
    );
}
