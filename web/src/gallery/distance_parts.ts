import { element } from '../page/element';
import { formatDistance, formatName } from '../page/format';

export interface PartShare {
    name: string;
    value: number;
    /** Of the sum of all parts, 0 to 1. */
    share: number;
    /** Place in the list of part names, which decides the colour. */
    index: number;
}

/**
 * The named parts of a distance as shares of the sum of all; what is negative or no number has no share.
 */
export function partShares(
    parts: Readonly<Record<string, number>>,
    names: readonly string[] = Object.keys(parts),
): PartShare[] {
    const weight = (value: number): number => (Number.isFinite(value) && value > 0 ? value : 0);
    const sum = Object.values(parts).reduce((total, value) => total + weight(value), 0);
    return Object.entries(parts)
        .filter(([name]) => names.includes(name))
        .map(([name, value]) => ({
            name,
            value,
            share: sum > 0 ? weight(value) / sum : 0,
            index: names.indexOf(name),
        }))
        .sort((a, b) => a.index - b.index);
}

/**
 * Names of all parts that count at any of the hits, in the order of their first appearance. Those of which
 * the ranker takes nothing, such as the pose of a search by build alone, are 0 at all of them.
 */
export function partNames(hits: readonly { parts: Readonly<Record<string, number>> }[]): string[] {
    const names = new Set(hits.flatMap((hit) => Object.keys(hit.parts)));
    return [...names].filter((name) => hits.some((hit) => (hit.parts[name] ?? 0) !== 0));
}

export const kPartColors = 8;

export function partClass(index: number): string {
    return `part part-${((index % kPartColors) + kPartColors) % kPartColors}`;
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
    const spoken = shares.map(({ name, value }) => `${formatName(name)} ${formatDistance(value)}`);
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
                .map(({ share, index }) =>
                    element('span', { class: partClass(index), '--share': share.toFixed(4) }),
                ),
        ),
    );
}

export function partsLegend(names: readonly string[]): HTMLElement | null {
    return names.length === 0
        ? null
        : element(
              'ul',
              { class: 'legend', 'aria-label': 'Parts of the distance' },
              names.map((name, index) =>
                  element(
                      'li',
                      {},
                      element('span', { class: `swatch ${partClass(index)}` }),
                      formatName(name),
                  ),
              ),
          );
}
