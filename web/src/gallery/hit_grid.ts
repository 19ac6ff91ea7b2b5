import type { Hit } from '../api/types';
import { element } from '../page/element';
import { partNames, partsLegend } from './distance_parts';
import { hitCard } from './hit_card';

/** All hits, best first, with what the colours of their bars mean. */
export function hitGrid(hits: readonly Hit[], hrefOf: (hit: Hit) => string): HTMLElement {
    const names = partNames(hits);
    const longest = Math.max(0, ...hits.map((hit) => hit.distance).filter(Number.isFinite));
    return element(
        'div',
        { class: 'hits' },
        partsLegend(names),
        element(
            'ol',
            { class: 'grid', 'aria-label': 'Hits, most similar first' },
            hits.map((hit) => hitCard(hit, { href: hrefOf(hit), partNames: names, longest })),
        ),
    );
}
