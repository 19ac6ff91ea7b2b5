import type { ClassMetrics, Confusion } from '../api/elements';
import type { Evaluation, Metrics } from '../api/types';
import type { Text } from '../words/say';

export interface MetricColumn {
    key: keyof Metrics;
    short: Text;
    long: Text;
}

/** In the order in which the literature's tables have them. */
export const kMetrics: readonly MetricColumn[] = [
    { key: 'nearest_neighbor', short: 'NN', long: 'Nearest neighbour' },
    { key: 'first_tier', short: 'FT', long: 'First tier' },
    { key: 'second_tier', short: 'ST', long: 'Second tier' },
    { key: 'e_measure', short: 'E', long: 'E-measure' },
    { key: 'dcg', short: 'DCG', long: 'Discounted cumulative gain' },
    { key: 'mean_average_precision', short: 'MAP', long: 'Mean average precision' },
];

export interface AlignedCurves {
    recall: number[];
    /** One row for each evaluation, as long as `recall`; null where it has no such point. */
    precision: (number | null)[][];
}

/** Curves over the union of their recalls, ascending, as a chart wants them. */
export function alignCurves(
    evaluations: readonly Pick<Evaluation, 'precision_recall'>[],
): AlignedCurves {
    const points = evaluations.map(
        (evaluation) =>
            new Map(evaluation.precision_recall.map((point) => [point.recall, point.precision])),
    );
    const recall = [...new Set(points.flatMap((curve) => [...curve.keys()]))].sort((a, b) => a - b);
    return {
        recall,
        precision: points.map((curve) => recall.map((at) => curve.get(at) ?? null)),
    };
}

/** Place of the best row in each column; none where all are equal. */
export function bestRows(rows: readonly Metrics[]): Map<keyof Metrics, number> {
    const best = new Map<keyof Metrics, number>();
    for (const { key } of kMetrics) {
        const values = rows.map((row) => row[key]);
        const most = Math.max(...values);
        if (values.some((value) => value < most)) {
            best.set(key, values.indexOf(most));
        }
    }
    return best;
}

export interface ClassRow extends ClassMetrics {
    name: string;
}

export interface ClassOrder {
    key: keyof ClassRow;
    descending: boolean;
}

export const kClassOrder: Readonly<ClassOrder> = { key: 'name', descending: false };

/** Equal values stay in the order of the names. */
export function sortedClasses(
    perClass: Readonly<Record<string, ClassMetrics>>,
    order: ClassOrder = kClassOrder,
): ClassRow[] {
    const sign = order.descending ? -1 : 1;
    const byName = (a: ClassRow, b: ClassRow): number => a.name.localeCompare(b.name, 'en');
    return Object.entries(perClass)
        .map(([name, metrics]) => ({ name, ...metrics }))
        .sort((a, b) => {
            if (order.key === 'name') {
                return sign * byName(a, b);
            }
            return sign * (a[order.key] - b[order.key]) || byName(a, b);
        });
}

export interface Mistake {
    from: string;
    to: string;
    share: number;
}

/** What is taken for what most often: the largest values off the diagonal. */
export function commonMistakes(confusion: Confusion, most = 5): Mistake[] {
    return confusion.classes
        .flatMap((from, row) =>
            confusion.classes.map((to, column) => ({
                from,
                to,
                share: row === column ? 0 : (confusion.values[row]?.[column] ?? 0),
            })),
        )
        .filter(({ share }) => share > 0)
        .sort((a, b) => b.share - a.share)
        .slice(0, most);
}
