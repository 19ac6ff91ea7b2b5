import { gzipSync } from 'node:zlib';
import { expect, it } from 'vitest';

import { Visits } from './visits';

/** Of code and styles, packed, before anything is seen. */
const kMostBytes = 25_000;

const visits = new Visits();

it('the start page is there before the viewer, the results and the charts are', async () => {
    const page = await visits.come();
    const bytes = new Map<string, number>();
    const late: string[] = [];
    let loaded = false;
    page.on('response', async (response) => {
        const { pathname } = new URL(response.url());
        if (/^\/$|\.(?:js|css)$/.test(pathname)) {
            if (loaded) {
                late.push(pathname);
            } else {
                bytes.set(pathname, gzipSync(await response.body()).length);
            }
        }
    });
    // What comes when there is nothing else to do is not waited for.
    await page.addInitScript(() => {
        globalThis.requestIdleCallback = () => 0;
    });
    await page.goto(`${visits.collection.origin}/#/`);
    await page.locator('.collection .thumbnail-ready').first().waitFor();
    const sum = [...bytes.values()].reduce((total, size) => total + size, 0);
    expect(bytes.size).toBeGreaterThan(2);
    expect(sum).toBeLessThan(kMostBytes);
    loaded = true;
    await page.getByRole('link', { name: 'Reports' }).click();
    await page.locator('.metrics-table tbody tr').first().waitFor();
    expect(late.some((path) => path.includes('reports_page'))).toBe(true);
    expect(visits.visitor.complaints).toEqual([]);
});

it('pictures that were seen are not asked for again', async () => {
    const page = await visits.come();
    await page.goto(`${visits.collection.origin}/#/`);
    await page.locator('.collection .thumbnail-ready').first().waitFor();
    await page.reload();
    await page.locator('.collection .thumbnail-ready').first().waitFor();
    const kept = await page.evaluate(() =>
        performance
            .getEntriesByType('resource')
            .filter((entry) => entry.name.includes('thumbnail'))
            .map((entry) => (entry as PerformanceResourceTiming).transferSize),
    );
    expect(kept.length).toBeGreaterThan(0);
    expect(kept).toEqual(kept.map(() => 0));
});
