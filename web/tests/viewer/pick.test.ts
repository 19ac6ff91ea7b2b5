import { describe, expect, it } from 'vitest';

import { distanceToSegment, nearestLine } from '../../src/viewer/pick';

const kLines = [
    {
        id: 4,
        points: [
            { x: 0, y: 0 },
            { x: 100, y: 0 },
        ],
    },
    {
        id: 9,
        points: [
            { x: 0, y: 20 },
            { x: 50, y: 20 },
            { x: 50, y: 100 },
        ],
    },
];

describe('nearestLine', () => {
    it('takes the nearer of two lines within reach', () => {
        expect(nearestLine(kLines, { x: 30, y: 7 }, 15)).toBe(4);
        expect(nearestLine(kLines, { x: 30, y: 13 }, 15)).toBe(9);
        expect(nearestLine(kLines, { x: 55, y: 80 }, 15)).toBe(9);
    });

    it('takes none out of reach, none of nothing and none from a lone point', () => {
        expect(nearestLine(kLines, { x: 300, y: 300 }, 15)).toBeNull();
        expect(nearestLine([], { x: 0, y: 0 }, 15)).toBeNull();
        expect(nearestLine([{ id: 1, points: [{ x: 0, y: 0 }] }], { x: 0, y: 0 }, 15)).toBeNull();
    });
});

describe('distanceToSegment', () => {
    it('measures to the ends beyond the ends, and to a point where there is no length', () => {
        expect(distanceToSegment({ x: -3, y: 4 }, { x: 0, y: 0 }, { x: 9, y: 0 })).toBe(5);
        expect(distanceToSegment({ x: 4, y: 2 }, { x: 0, y: 0 }, { x: 9, y: 0 })).toBe(2);
        expect(distanceToSegment({ x: 3, y: 4 }, { x: 0, y: 0 }, { x: 0, y: 0 })).toBe(5);
    });
});
