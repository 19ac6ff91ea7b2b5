import type { HitOrder } from '../api/search_parameters';
import type { Hit, SearchResult } from '../api/types';
import { append, type Child, element } from '../page/element';
import type { Selection } from '../page/selection';
import { say } from '../words/say';
import type { LikeHit } from './build_and_pose';
import { partNames, partsLegend } from './distance_parts';
import { hitCard } from './hit_card';
import { orderLabel } from './hit_order';
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
    order: HitOrder;
    hrefOf: (hit: Hit) => string;
    likeOf: (hit: Hit) => LikeHit;
    selection: Selection;
    /** Asks for more hits; null: there are none. */
    onMore: (() => void) | null;
    /** So many of them are there from the start, the others a few a frame later. */
    first?: number;
}

/** Cards that a frame has time for. */
const kAtOnce = 6;

export interface HitGrid {
    node: HTMLElement;
    /** Once all hits are there, or the grid is gone. */
    whole: Promise<void>;
}

/** Adds what is left of a list, a few a frame, so that no hand waits for all of them. */
async function addLater(list: HTMLElement, cards: readonly (() => Child)[]): Promise<void> {
    for (let at = 0; at < cards.length; at += kAtOnce) {
        await new Promise((resolve) => setTimeout(resolve, 0));
        if (!list.isConnected) {
            return;
        }
        append(list, ...cards.slice(at, at + kAtOnce).map((card) => card()));
    }
}

/** All hits, best first, with what the colours of their bars mean. */
export function hitGrid(
    { hits, ranker, part }: SearchResult,
    { order, hrefOf, likeOf, selection, onMore, first = 0 }: HitGridOptions,
): HitGrid {
    const names = partNames(hits);
    const nearness = hits.map((hit) => nearnessOf(hit.distance, { ranker, part }));
    const cut = order === 'distance' ? nearness.indexOf('far') : -1;
    const cards = hits.map(
        (hit, at) => (): Child => [
            at === cut && cutLine(),
            hitCard(hit, {
                href: hrefOf(hit),
                like: likeOf(hit),
                partNames: names,
                nearness: nearness[at] ?? null,
                selection,
            }),
        ],
    );
    const soon = Math.max(kAtOnce, first);
    const list = element(
        'ol',
        { class: 'grid', 'aria-label': orderLabel(order) },
        cards.slice(0, soon).map((card) => card()),
    );
    const node = element(
        'div',
        { class: 'hits' },
        partsLegend(names),
        list,
        onMore &&
            element(
                'button',
                { type: 'button', class: 'button more-hits', click: onMore },
                say('Show more hits'),
            ),
    );
    return { node, whole: addLater(list, cards.slice(soon)) };
}
