import type { Ranker } from '../api/types';

/** The style sheet's name of a ranker's colour, the same in the chart and in the tables. */
export function rankerColorName(ranker: Ranker): string {
    return `--ranker-${ranker}`;
}

export function rankerColor(ranker: Ranker): string {
    const styles = getComputedStyle(document.documentElement);
    return styles.getPropertyValue(rankerColorName(ranker)).trim() || '#1f8a76';
}
