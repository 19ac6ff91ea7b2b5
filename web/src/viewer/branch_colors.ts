import type { SkeletonBranch } from '../api/elements';
import type { Pair } from '../api/types';

export interface ColoredPair extends Pair {
    /** 1, 2, …: the number that the table and the label show, since colour alone must not tell. */
    number: number;
    /** `#rrggbb`. */
    color: string;
}

export interface BranchColors {
    pairs: ColoredPair[];
    /** Pair by the id of its branch on the query's side. */
    query: Map<number, ColoredPair>;
    /** Pair by the id of its branch on the hit's side. */
    hit: Map<number, ColoredPair>;
}

const kGoldenAngle = 137.50776;
const kFirstHue = 28;
const kChroma = 0.145;
/**
 * Neighbours in the order of hues differ in lightness too, which tells them apart in grey. Least
 * distance of the first twelve in OKLab: 0.112; with a cycle of four (.72 .62 .8 .67) 0.051; steps
 * of 150 degrees reach 0.145, but repeat after twelve.
 */
const kLightness = [0.7, 0.58, 0.8];

function channel(linear: number): string {
    const clamped = Math.min(1, Math.max(0, linear));
    const encoded = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * clamped ** (1 / 2.4) - 0.055;
    return Math.round(encoded * 255)
        .toString(16)
        .padStart(2, '0');
}

/** OKLCH (lightness 0 to 1, chroma, hue in degrees) → `#rrggbb`, clipped to sRGB. */
export function oklch(lightness: number, chroma: number, hueDegrees: number): string {
    const hue = (hueDegrees * Math.PI) / 180;
    const a = chroma * Math.cos(hue);
    const b = chroma * Math.sin(hue);
    const long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
    const medium = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
    const short = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
    const red = 4.0767416621 * long - 3.3077115913 * medium + 0.2309699292 * short;
    const green = -1.2684380046 * long + 2.6097574011 * medium - 0.3413193965 * short;
    const blue = -0.0041960863 * long - 0.7034186147 * medium + 1.707614701 * short;
    return `#${channel(red)}${channel(green)}${channel(blue)}`;
}

/** The colour of the n-th pair. The golden angle keeps any number of hues apart. */
export function pairColor(index: number): string {
    const lightness = kLightness[index % kLightness.length] ?? 0.7;
    return oklch(lightness, kChroma, (kFirstHue + index * kGoldenAngle) % 360);
}

/**
 * One colour for each matched pair, the same on both sides; longer branches of the query get the
 * first, most distinct colours. Does not depend on the order of `matched`.
 */
export function assignBranchColors(
    matched: readonly Pair[],
    queryBranches: readonly SkeletonBranch[],
): BranchColors {
    const length = new Map(queryBranches.map((branch) => [branch.id, branch.length]));
    const ordered = [...matched].sort(
        (x, y) => (length.get(y.a) ?? 0) - (length.get(x.a) ?? 0) || x.a - y.a || x.b - y.b,
    );
    const colors: BranchColors = { pairs: [], query: new Map(), hit: new Map() };
    for (const [index, pair] of ordered.entries()) {
        const colored = { ...pair, number: index + 1, color: pairColor(index) };
        colors.pairs.push(colored);
        colors.query.set(pair.a, colored);
        colors.hit.set(pair.b, colored);
    }
    return colors;
}
