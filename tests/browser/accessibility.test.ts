import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';

import { kStateNames, pageStates, type State } from './page_states';
import { Visits } from './visits';

const kAxe = readFileSync(
    fileURLToPath(new URL('../../web/node_modules/axe-core/axe.min.js', import.meta.url)),
    'utf8',
);

const visits = new Visits();

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

describe.each([390, 1440])('axe-core finds nothing at %d px, light and dark,', (width) => {
    it.each(kStateNames)('in %s', async (name) => {
        const { hash, prepare, reach } = pageStates(visits.collection.models)[name] as State;
        const viewport = { width, height: width < 1000 ? 844 : 900 };
        const page = await visits.come({ viewport, colorScheme: 'light', bypassCSP: true });
        await prepare?.(page);
        await page.goto(`${visits.collection.origin}/${hash}`);
        await reach(page);
        const found: Record<string, string[]> = {};
        // The style sheet alone tells them apart: one visit shows both.
        for (const colorScheme of ['light', 'dark'] as const) {
            await page.emulateMedia({ colorScheme });
            found[colorScheme] = await violations(page);
        }
        expect(found).toEqual({ light: [], dark: [] });
    });
});
