import { say, spokenLanguage, type Text } from '../words/say';

const formats = new Map<string, Intl.NumberFormat>();

function numbers(options: Intl.NumberFormatOptions = {}): Intl.NumberFormat {
    const language = spokenLanguage();
    const key = `${language} ${JSON.stringify(options)}`;
    const known = formats.get(key) ?? new Intl.NumberFormat(language, options);
    formats.set(key, known);
    return known;
}

export function formatCount(count: number): string {
    return numbers().format(count);
}

export function formatPlural(count: number, singular: Text, plural: Text): string {
    return `${formatCount(count)} ${say(count === 1 ? singular : plural)}`;
}

/** Three significant places are enough to tell neighbours in a ranked list apart. */
export function formatDistance(distance: number): string {
    if (!Number.isFinite(distance)) {
        return '–';
    }
    return distance >= 100 ? distance.toFixed(0) : distance.toFixed(3);
}

const kSize = { maximumSignificantDigits: 4 } as const;

/** Length, width and height of a box along the axes of a file, in its unit if it names one. */
export function formatSize(
    { min, max }: { min: readonly number[]; max: readonly number[] },
    unit: string | null,
): string {
    const lengths = max.map((high, axis) => numbers(kSize).format(high - (min[axis] ?? 0)));
    return [lengths.join(' × '), ...(unit === null ? [] : [unit])].join(' ');
}

/** A length in the unit of a file, if it names one. */
export function formatLength(length: number, unit: string | null): string {
    return unit === null
        ? numbers(kSize).format(length)
        : `${numbers(kSize).format(length)} ${unit}`;
}

export function formatShare(share: number): string {
    return Number.isFinite(share) ? share.toFixed(3) : '–';
}

export function formatDuration(milliseconds: number): string {
    if (milliseconds >= 10_000) {
        return `${(milliseconds / 1000).toFixed(0)} s`;
    }
    if (milliseconds >= 1000) {
        return `${(milliseconds / 1000).toFixed(1)} s`;
    }
    return milliseconds >= 10 || milliseconds === 0
        ? `${milliseconds.toFixed(0)} ms`
        : `${milliseconds.toFixed(1)} ms`;
}

export function formatBytes(bytes: number): string {
    if (bytes < 1000) {
        return `${bytes} B`;
    }
    const units = ['kB', 'MB', 'GB'];
    let value = bytes / 1000;
    let unit = 0;
    // 999.5 would be rounded to 1000 of the smaller unit.
    while (value >= 999.5 && unit < units.length - 1) {
        value /= 1000;
        unit += 1;
    }
    return `${value >= 99.5 ? value.toFixed(0) : value.toFixed(1)} ${units[unit]}`;
}

/** `mean_average_precision` → `mean average precision`. */
export function formatName(identifier: string): string {
    return identifier.replaceAll('_', ' ').replaceAll('-', ' ').trim();
}

/** A label with its first letter raised, the rest as it was. */
export function capitalise(text: string): string {
    return text === '' ? '' : text.charAt(0).toUpperCase() + text.slice(1);
}
