import type { Hit, Skeleton } from '../api/types';
import { element } from '../page/element';
import { formatName } from '../page/format';
import { partShares } from './distance_parts';
import { kNearnessMeanings, type Nearness } from './nearness';
import { say, sayName, type Text } from '../words/say';

/** What most of a distance is made of; null where no part is most of it. */
function mainPart(hit: Hit): string | null {
    const [first] = partShares(hit.parts).sort((a, b) => b.share - a.share);
    return first && first.share >= 0.3 ? sayName(formatName(first.name)) : null;
}

function counterparts(matched: number, count: number): Text {
    if (count === 1) {
        return '{matched} of the query’s {count} branch has a counterpart';
    }
    return matched === 1
        ? '{matched} of the query’s {count} branches has a counterpart'
        : '{matched} of the query’s {count} branches have a counterpart';
}

/** In one sentence, why a hit is where it is. */
export function whyLine(hit: Hit, query: Skeleton, nearness: Nearness | null): HTMLElement {
    const matched = hit.match.branches.length;
    const count = query.branches.length;
    const main = nearness === 'same' ? null : mainPart(hit);
    return element(
        'p',
        { class: 'why' },
        nearness && `${say(kNearnessMeanings[nearness])} `,
        say(counterparts(matched, count), { matched, count }),
        main && say('; they differ most in {main}', { main }),
        '.',
    );
}
