import type { Ranker } from '../api/types';
import type { Text } from '../words/say';

/** How near a hit is, in a word. */
export type Nearness = 'same' | 'very close' | 'related' | 'far';

/** The distances up to which a hit is one of these. */
interface Bounds {
    same: number;
    veryClose: number;
    related: number;
}

/**
 * The fused rankers' distances are normalised by the collection: two of its models are about 1 apart.
 * Of the pairs among the 380 models of the Princeton segmentation benchmark (19 classes, `evaluate
 * --matrix`) that `hybrid` has within .15, 96 % are of one class, and 47 % of those of one class are
 * there; within .3 it is 73 % and 83 %, within .45 only 37 % and 92 %. `skeleton`: 94 % and 47 %, 61 %
 * and 78 %. Chain codes alone tell less: half of the pairs of one class lie within .89, one in twenty
 * of the others within .86.
 */
const kFused: Bounds = { same: 0.001, veryClose: 0.15, related: 0.3 };
const kBounds: Record<Ranker, Bounds> = {
    hybrid: kFused,
    skeleton: kFused,
    'chain-code': { same: 0.001, veryClose: 0.5, related: 0.85 },
};

/** A distance as long as the whole bar: as two models usually are. */
export const kUsualDistance = 1;

/** Null for parts, which lie in what may be as unlike as anything. */
export function nearnessOf(
    distance: number,
    { ranker, part }: { ranker: Ranker; part: boolean },
): Nearness | null {
    if (part || !Number.isFinite(distance)) {
        return null;
    }
    const { same, veryClose, related } = kBounds[ranker];
    if (distance <= same) {
        return 'same';
    }
    if (distance <= veryClose) {
        return 'very close';
    }
    return distance <= related ? 'related' : 'far';
}

export const kNearnessMeanings: Record<Nearness, Text> = {
    same: 'The same shape.',
    'very close': 'Nearer than half of the pairs of one kind usually are.',
    related: 'As near as models of one kind usually are.',
    far: 'Further away than models of one kind usually are.',
};
