import type { Hit, SearchResult } from '../api/types';
import { element } from '../page/element';
import type { Selection } from '../page/selection';
import { say } from '../words/say';
import type { LikeHit } from './build_and_pose';
import { partNames, partsLegend } from './distance_parts';
import { hitCard } from './hit_card';
import { nearnessOf } from './nearness';

/** Between hits of the query's kind and others. */
function cutLine(): HTMLElement {
    return element(
        'li',
        { class: 'cut-line' },
        element('span', {}, say('Further away than models of one kind usually are')),
    );
}

export interface HitGridOptions {
    hrefOf: (hit: Hit) => string;
    likeOf: (hit: Hit) => LikeHit;
    selection: Selection;
    /** Asks for more hits; null: there are none. */
    onMore: (() => void) | null;
}

/** All hits, best first, with what the colours of their bars mean. */
export function hitGrid(
    { hits, ranker, part }: SearchResult,
    { hrefOf, likeOf, selection, onMore }: HitGridOptions,
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
            { class: 'grid', 'aria-label': say('Hits, most similar first') },
            hits.map((hit, at) => [
                at === cut && cutLine(),
                hitCard(hit, {
                    href: hrefOf(hit),
                    like: likeOf(hit),
                    partNames: names,
                    nearness: nearness[at] ?? null,
                    selection,
                }),
            ]),
        ),
        onMore &&
            element(
                'button',
                { type: 'button', class: 'button more-hits', click: onMore },
                say('Show more hits'),
            ),
    );
}
