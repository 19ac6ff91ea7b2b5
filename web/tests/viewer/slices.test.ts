import { expect, it } from 'vitest';

import { atOnce, inSlices } from '../../src/viewer/slices';

function* counting(to: number, held: { open: boolean }): Generator<void, number> {
    held.open = true;
    try {
        for (let at = 0; at < to; at++) {
            const until = performance.now() + 2;
            while (performance.now() < until) {
                // Work.
            }
            yield;
        }
        return to;
    } finally {
        held.open = false;
    }
}

it('does the same in slices as in one go, and lets others have their turn', async () => {
    expect(atOnce(counting(3, { open: false }))).toBe(3);
    let turns = 0;
    const timer = setInterval(() => {
        turns += 1;
    }, 1);
    expect(await inSlices(counting(40, { open: false }))).toBe(40);
    clearInterval(timer);
    expect(turns).toBeGreaterThan(2);
});

it('gives up what is not wanted any more, and gives back what it held', async () => {
    const held = { open: false };
    let looks = 0;
    const found = await inSlices(counting(1000, held), () => {
        looks += 1;
        return looks < 3;
    });
    expect(found).toBeNull();
    expect(held.open).toBe(false);
});
