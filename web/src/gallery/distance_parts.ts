import { element } from '../page/element';
import { formatDistance, formatName } from '../page/format';
import { say, sayName } from '../words/say';

/** The parts that rankers name, in the order in which they are shown, each with its colour. */
const kColors: Readonly<Record<string, number>> = {
    skeleton: 0,
    code: 0,
    matched_branches: 0,
    exchanged: 0,
    length: 3,
    unmatched: 7,
    unmatched_branches: 7,
    skeleton_pairs: 1,
    skeleton_layout: 2,
    views: 4,
    surface_pairs: 5,
    local_volume: 6,
    radial_thickness: 3,
    build: 8,
    pose: 9,
    size: 7,
};
const kOrder = Object.keys(kColors);

/** A colour means the same part in every search. */
export function partClass(name: string): string {
    return `part part-${kColors[name] ?? 7}`;
}

function byOrder(a: string, b: string): number {
    const place = (name: string): number => {
        const at = kOrder.indexOf(name);
        return at < 0 ? kOrder.length : at;
    };
    return place(a) - place(b) || a.localeCompare(b, 'en');
}

export interface PartShare {
    name: string;
    value: number;
    /** Of the sum of all parts, 0 to 1. */
    share: number;
}

/**
 * The named parts of a distance as shares of the sum of all, in the order in which they are shown;
 * what is negative or no number has no share.
 */
export function partShares(
    parts: Readonly<Record<string, number>>,
    names: readonly string[] = Object.keys(parts),
): PartShare[] {
    const weight = (value: number): number => (Number.isFinite(value) && value > 0 ? value : 0);
    const sum = Object.values(parts).reduce((total, value) => total + weight(value), 0);
    return Object.entries(parts)
        .filter(([name]) => names.includes(name))
        .map(([name, value]) => ({ name, value, share: sum > 0 ? weight(value) / sum : 0 }))
        .sort((a, b) => byOrder(a.name, b.name));
}

/**
 * Names of all parts that count at any of the hits, in the order in which they are shown. Those of which
 * the ranker takes nothing, such as the pose of a search by build alone, are 0 at all of them.
 */
export function partNames(hits: readonly { parts: Readonly<Record<string, number>> }[]): string[] {
    const names = new Set(hits.flatMap((hit) => Object.keys(hit.parts)));
    return [...names]
        .filter((name) => hits.some((hit) => (hit.parts[name] ?? 0) !== 0))
        .sort(byOrder);
}

/**
 * A bar as long as the distance (against `longest`), divided by its parts.
 */
export function partsBar(
    parts: Readonly<Record<string, number>>,
    names: readonly string[],
    length: number,
): HTMLElement {
    const shares = partShares(parts, names);
    const spoken = shares.map(
        ({ name, value }) => `${sayName(formatName(name))} ${formatDistance(value)}`,
    );
    return element(
        'span',
        {
            class: 'parts-track',
            role: 'img',
            'aria-label': spoken.join(', '),
            title: spoken.join('\n'),
        },
        element(
            'span',
            { class: 'parts-bar', '--length': Math.min(1, Math.max(0, length)).toFixed(4) },
            shares
                .filter(({ share }) => share > 0)
                .map(({ name, share }) =>
                    element('span', { class: partClass(name), '--share': share.toFixed(4) }),
                ),
        ),
    );
}

export function partsLegend(names: readonly string[]): HTMLElement | null {
    return names.length === 0
        ? null
        : element(
              'ul',
              { class: 'legend', 'aria-label': say('Parts of the distance') },
              names.map((name) =>
                  element(
                      'li',
                      {},
                      element('span', { class: `swatch ${partClass(name)}` }),
                      sayName(formatName(name)),
                  ),
              ),
          );
}
