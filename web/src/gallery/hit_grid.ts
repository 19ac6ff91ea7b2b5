import type { Hit, SearchResult } from '../api/types';
import { element } from '../page/element';
import type { LikeHit } from './build_and_pose';
import { partNames, partsLegend } from './distance_parts';
import { hitCard } from './hit_card';
import { nearnessOf } from './nearness';

/** Between hits of the query's kind and others. */
function cutLine(): HTMLElement {
    return element(
        'li',
        { class: 'cut-line' },
        element('span', {}, 'Further away than models of one kind usually are'),
    );
}

export interface HitLinks {
    hrefOf: (hit: Hit) => string;
    likeOf: (hit: Hit) => LikeHit;
}

/** All hits, best first, with what the colours of their bars mean. */
export function hitGrid(
    { hits, ranker, part }: SearchResult,
    { hrefOf, likeOf }: HitLinks,
): HTMLElement {
    const names = partNames(hits);
    const nearness = hits.map((hit) => nearnessOf(hit.distance, { ranker, part }));
    const cut = nearness.indexOf('far');
    return element(
        'div',
        { class: 'hits' },
        partsLegend(names),
        element(
            'ol',
            { class: 'grid', 'aria-label': 'Hits, most similar first' },
            hits.map((hit, at) => [
                at === cut && cutLine(),
                hitCard(hit, {
                    href: hrefOf(hit),
                    like: likeOf(hit),
                    partNames: names,
                    nearness: nearness[at] ?? null,
                }),
            ]),
        ),
    );
}
