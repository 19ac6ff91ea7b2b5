import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';

import { layoutFaults } from './layout_faults';
import { kStateNames, pageStates, type State, seen } from './page_states';
import { Visits } from './visits';

const kNarrow = { width: 320, height: 700 };

const visits = new Visits();

async function reach({ hash, prepare, reach: arrive }: State): Promise<Page> {
    const page = await visits.come({ viewport: kNarrow });
    await prepare?.(page);
    await page.goto(`${visits.collection.origin}/${hash}`);
    await arrive(page);
    return page;
}

it('would notice a grid that insists on the width of its contents', async () => {
    const page = await reach({ hash: '#/', reach: seen('.collection .card-link') });
    await page.evaluate(() => {
        for (const card of document.querySelectorAll<HTMLElement>('.card')) {
            card.style.minWidth = 'max-content';
        }
    });
    expect((await layoutFaults(page)).length).toBeGreaterThan(0);
});

describe(`at ${kNarrow.width} px, whatever the width of letters`, () => {
    it.each(kStateNames)('nothing sticks out of %s', async (name) => {
        const page = await reach(pageStates(visits.collection.models)[name] as State);
        expect(await layoutFaults(page)).toEqual([]);
    });
});
