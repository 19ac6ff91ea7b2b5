import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';

import { type ServedCollection, serveCollection } from './collection';
import { layoutFaults } from './layout_faults';
import { kStateNames, pageStates, type State, seen } from './page_states';
import { type Visitor, visit } from './visitor';

const kNarrow = { width: 320, height: 700 };

let collection: ServedCollection;
let visitor: Visitor;

beforeAll(async () => {
    collection = await serveCollection();
});

afterAll(async () => {
    await collection?.stop();
});

afterEach(async () => {
    await visitor?.close();
});

async function reach({ hash, prepare, reach: arrive }: State): Promise<Page> {
    visitor = await visit(collection.browser, collection.origin, { viewport: kNarrow });
    const { page } = visitor;
    await prepare?.(page);
    await page.goto(`${collection.origin}/${hash}`);
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
        const page = await reach(pageStates(collection.models)[name] as State);
        expect(await layoutFaults(page)).toEqual([]);
    });
});
