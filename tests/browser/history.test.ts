import type { Page } from 'playwright-core';
import { afterEach, expect, it } from 'vitest';

import { Visits } from './visits';

const kLow = { width: 420, height: 500 };

const visits = new Visits();

afterEach(() => {
    expect(visits.visitor.complaints).toEqual([]);
});

async function open(hash: string): Promise<Page> {
    return visits.open(hash, { viewport: kLow });
}

function focused(page: Page): Promise<string | null> {
    return page.evaluate(() => document.activeElement?.getAttribute('href') ?? null);
}

it('one step back leads out of the hits, whatever was looked at there', async () => {
    const page = await open('#/');
    await page.locator('.collection .card-link').first().click();
    await page.locator('.hit-card').first().waitFor();
    const results = page.url();
    await page.locator('.hit-card .card-link').first().click();
    const dialog = page.locator('dialog');
    await dialog.waitFor();
    for (const wanted of [1, 2, 3]) {
        await page.getByRole('button', { name: 'Next hit' }).click();
        await page.waitForURL(`${results}/hits/*`);
        const name = await page.locator('.hit-card .card-name').nth(wanted).textContent();
        await dialog
            .getByRole('heading')
            .filter({ hasText: String(name) })
            .waitFor();
        // The focus stays on what was pressed.
        expect(await page.evaluate(() => document.activeElement?.id)).toBe('next-hit');
        expect(await page.title()).toContain(`↔ ${name}`);
    }
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'detached' });
    expect(page.url()).toBe(results);
    // Back at the hit that was seen last.
    expect(await focused(page)).toBe(
        await page.locator('.hit-card .card-link').nth(3).getAttribute('href'),
    );
    await page.goBack();
    await page.locator('.drop-zone').waitFor();
});

it('the parts of a hit lead back to its comparison', async () => {
    const page = await open('#/models/1');
    await page.locator('.hit-card .card-link').nth(1).click();
    await page.locator('dialog .match-table').waitFor();
    const comparison = page.url();
    await page.getByRole('link', { name: 'Its parts' }).click();
    await page.locator('dialog .part-legend').waitFor();
    await page.getByRole('button', { name: 'Close' }).click();
    await page.locator('dialog .match-table').waitFor();
    expect(page.url()).toBe(comparison);
});

it('a shared address of a comparison closes onto its hits', async () => {
    const page = await open('#/models/1/hits/2');
    await page.locator('dialog .match-table').waitFor();
    await page.getByRole('button', { name: 'Close' }).click();
    await page.locator('dialog').waitFor({ state: 'detached' });
    expect(page.url()).toBe(`${visits.collection.origin}/#/models/1`);
});

it('the collection is found where it was left, with the focus on the same model', async () => {
    const page = await open('#/');
    const href = await page.locator('.collection .card-link').last().getAttribute('href');
    // By its address: further rows are drawn on the way, and another one is the last then.
    const link = page.locator(`.collection .card-link[href="${href}"]`);
    await link.scrollIntoViewIfNeeded();
    // Clicking may scroll further, where something lies over the link.
    await page.evaluate(() =>
        addEventListener('click', () => sessionStorage.setItem('place', `${scrollY}`), {
            capture: true,
            once: true,
        }),
    );
    await link.click();
    const place = Number(await page.evaluate(() => sessionStorage.getItem('place')));
    expect(place).toBeGreaterThan(300);
    await page.locator('.hit-card').first().waitFor();
    expect(await page.evaluate(() => scrollY)).toBe(0);
    await page.goBack();
    await page.waitForFunction((wanted) => Math.abs(scrollY - wanted) < 2, place);
    await page.waitForFunction(
        (wanted) => document.activeElement?.getAttribute('href') === wanted,
        href,
    );
});
