import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

import { type ServedCollection, serveCollection } from './collection';
import { kStateNames, pageStates, type State } from './page_states';
import { visit } from './visitor';

const kAxe = readFileSync(
    fileURLToPath(new URL('../../web/node_modules/axe-core/axe.min.js', import.meta.url)),
    'utf8',
);

let collection: ServedCollection;

beforeAll(async () => {
    collection = await serveCollection();
});

afterAll(async () => {
    await collection?.stop();
});

/** What axe-core finds, by WCAG 2.2 A and AA and by good practice. */
async function violations(page: Page): Promise<string[]> {
    await page.evaluate(kAxe);
    return page.evaluate(async () => {
        const { axe } = globalThis as unknown as {
            axe: {
                run(): Promise<{
                    violations: { id: string; nodes: { html: string; failureSummary: string }[] }[];
                }>;
            };
        };
        const found = await axe.run();
        return found.violations.flatMap(({ id, nodes }) =>
            nodes.map(
                ({ html, failureSummary }) => `${id}: ${html.slice(0, 160)} ${failureSummary}`,
            ),
        );
    });
}

describe.each(['light', 'dark'] as const)('axe-core finds nothing, %s,', (colorScheme) => {
    describe.each([390, 1440])('at %d px,', (width) => {
        it.each(kStateNames)('in %s', async (name) => {
            const { hash, prepare, reach } = pageStates(collection.models)[name] as State;
            const viewport = { width, height: width < 1000 ? 844 : 900 };
            const visitor = await visit(collection.browser, collection.origin, {
                viewport,
                colorScheme,
                bypassCSP: true,
            });
            try {
                const { page } = visitor;
                await prepare?.(page);
                await page.goto(`${collection.origin}/${hash}`);
                await reach(page);
                expect(await violations(page)).toEqual([]);
            } finally {
                await visitor.close();
            }
        });
    });
});
