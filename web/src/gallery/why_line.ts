import type { Hit, Skeleton } from '../api/types';
import { element } from '../page/element';
import { formatName, formatPlural } from '../page/format';
import { partShares } from './distance_parts';
import { kNearnessMeanings, type Nearness } from './nearness';

/** What most of a distance is made of; null where no part is most of it. */
function mainPart(hit: Hit): string | null {
    const [first] = partShares(hit.parts).sort((a, b) => b.share - a.share);
    return first && first.share >= 0.3 ? formatName(first.name) : null;
}

/** In one sentence, why a hit is where it is. */
export function whyLine(hit: Hit, query: Skeleton, nearness: Nearness | null): HTMLElement {
    const matched = hit.match.branches.length;
    const branches = formatPlural(query.branches.length, 'branch', 'branches');
    const main = nearness === 'same' ? null : mainPart(hit);
    return element(
        'p',
        { class: 'why' },
        nearness && `${kNearnessMeanings[nearness]} `,
        `${matched} of the query’s ${branches} ${matched === 1 ? 'has' : 'have'} a counterpart`,
        main && `; they differ most in ${main}`,
        '.',
    );
}
