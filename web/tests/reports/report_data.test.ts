import { describe, expect, it } from 'vitest';

import {
    alignCurves,
    bestRows,
    commonMistakes,
    kMetrics,
    sortedClasses,
} from '../../src/reports/report_data';
import { evaluation } from '../sample';

const curve = (...points: [number, number][]) => ({
    precision_recall: points.map(([recall, precision]) => ({ recall, precision })),
});

describe('alignCurves', () => {
    it('keeps every point of every curve, over ascending recalls', () => {
        const curves = [curve([1, 0.2], [0.5, 0.8]), curve([0.25, 0.9], [0.5, 0.7]), curve()];
        const { recall, precision } = alignCurves(curves);
        expect(recall).toEqual([0.25, 0.5, 1]);
        for (const [row, { precision_recall }] of curves.entries()) {
            const known = precision[row]?.filter((value) => value !== null);
            expect(known).toHaveLength(precision_recall.length);
            for (const point of precision_recall) {
                expect(precision[row]?.[recall.indexOf(point.recall)]).toBe(point.precision);
            }
        }
    });
});

describe('bestRows', () => {
    it('finds the largest of each column, and none where all are equal', () => {
        const rows = [
            evaluation({ nearest_neighbor: 0.5, dcg: 0.9 }),
            evaluation({ nearest_neighbor: 0.8, dcg: 0.7 }),
        ];
        const best = bestRows(rows);
        expect(best.get('nearest_neighbor')).toBe(1);
        expect(best.get('dcg')).toBe(0);
        expect(best.has('first_tier')).toBe(false);
        expect(bestRows([evaluation()]).size).toBe(0);
        expect(bestRows([]).size).toBe(0);
    });
});

describe('sortedClasses', () => {
    const metrics = evaluation().per_class;

    it('loses no class in any order', () => {
        for (const { key } of kMetrics) {
            for (const descending of [false, true]) {
                const rows = sortedClasses(metrics, { key, descending });
                expect(rows.map(({ name }) => name).sort()).toEqual(['ant', 'table']);
                const [first, second] = rows.map((row) => row[key]);
                expect(Number(first) <= Number(second)).toBe(!descending || first === second);
            }
        }
    });

    it('breaks ties by name', () => {
        const order = { key: 'dcg', descending: true } as const;
        expect(sortedClasses(metrics, order).map(({ name }) => name)).toEqual(['ant', 'table']);
        const backwards = { key: 'name', descending: true } as const;
        expect(sortedClasses(metrics, backwards).map(({ name }) => name)).toEqual(['table', 'ant']);
    });
});

describe('commonMistakes', () => {
    it('lists the largest values off the diagonal', () => {
        const confusion = {
            classes: ['a', 'b', 'c'],
            values: [
                [0.5, 0.1, 0.4],
                [0, 1, 0],
                [0.3, 0, 0.7],
            ],
        };
        expect(commonMistakes(confusion, 2)).toEqual([
            { from: 'a', to: 'c', share: 0.4 },
            { from: 'c', to: 'a', share: 0.3 },
        ]);
        expect(commonMistakes({ classes: ['a'], values: [[1]] })).toEqual([]);
        expect(commonMistakes({ classes: ['a', 'b'], values: [] })).toEqual([]);
    });
});
