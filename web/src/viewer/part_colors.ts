import type { SegmentPart } from '../api/elements';
import { pairColor } from './branch_colors';

const kPalette = 12;

function linear(encoded: number): number {
    const share = encoded / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

/** `#rrggbb` in OKLab, where distances are about as large as they look. */
export function oklab(color: string): [number, number, number] {
    const channel = (at: number): number => linear(Number.parseInt(color.slice(at, at + 2), 16));
    const red = channel(1);
    const green = channel(3);
    const blue = channel(5);
    const long = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
    const medium = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
    const short = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
    return [
        0.2104542553 * long + 0.793617785 * medium - 0.0040720468 * short,
        1.9779984951 * long - 2.428592205 * medium + 0.4505937099 * short,
        0.0259040371 * long + 0.7827717662 * medium - 0.808675766 * short,
    ];
}

export function colorDistance(a: string, b: string): number {
    const [x, y] = [oklab(a), oklab(b)];
    return Math.hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

/**
 * A colour for each part, out of twelve: parts that touch are as far apart as can be, and a colour
 * comes again only where all are taken by larger parts. Larger parts choose first.
 */
export function partColors(parts: readonly SegmentPart[]): string[] {
    const palette = Array.from({ length: kPalette }, (_, index) => pairColor(index));
    const uses = new Map(palette.map((color) => [color, 0]));
    const chosen: string[] = [];
    for (const [index, part] of parts.entries()) {
        const around = part.neighbors
            .filter((other) => other < index)
            .map((other) => chosen[other] ?? '');
        const taken = (color: string): number => uses.get(color) ?? 0;
        const apart = (color: string): number =>
            Math.min(1, ...around.map((other) => colorDistance(color, other)));
        const free = palette.filter((color) => !around.includes(color));
        const [best] = (free.length > 0 ? free : palette).toSorted(
            (a, b) => taken(a) - taken(b) || apart(b) - apart(a),
        );
        const color = best ?? pairColor(0);
        uses.set(color, taken(color) + 1);
        chosen.push(color);
    }
    return chosen;
}
