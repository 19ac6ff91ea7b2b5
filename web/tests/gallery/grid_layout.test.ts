import { describe, expect, it } from 'vitest';

import { cardsBetween, gridHeight, gridLayout, placeOf } from '../../src/gallery/grid_layout';

describe('the grid', () => {
    it.each([0, 288, 358, 600, 1280, 1440, 4000])('fits into %d pixels', (width) => {
        const layout = gridLayout(width);
        const { columns, cardWidth, gap } = layout;
        expect(columns).toBeGreaterThanOrEqual(2);
        expect(columns * cardWidth + (columns - 1) * gap).toBeCloseTo(Math.max(width, 2 + gap), 6);
    });

    it('holds every card once, in rows', () => {
        const layout = gridLayout(1000);
        const places = Array.from({ length: 23 }, (_, index) => placeOf(layout, index));
        expect(new Set(places.map(({ x, y }) => `${x} ${y}`)).size).toBe(23);
        const bottom = Math.max(...places.map(({ y }) => y)) + layout.cardHeight;
        expect(bottom).toBeCloseTo(gridHeight(layout, 23), 6);
        expect(gridHeight(layout, 0)).toBe(0);
    });

    it('finds the cards between two heights, whole rows and no more', () => {
        const layout = gridLayout(1000);
        const step = layout.cardHeight + layout.gap;
        for (const [top, bottom] of [
            [-500, 10],
            [3.2 * step, 5.1 * step],
            [99 * step, 200 * step],
        ] as const) {
            const { first, end } = cardsBetween(layout, 230, top, bottom);
            for (let index = 0; index < 230; index++) {
                const { y } = placeOf(layout, index);
                const inSight = y < bottom && y + step > top;
                expect(index >= first && index < end).toBe(inSight);
            }
        }
    });
});
