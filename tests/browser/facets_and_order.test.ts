import { afterEach, describe, expect, it } from 'vitest';

import { kClasses, kModelsPerClass } from './models';
import { Visits } from './visits';

const kModels = kClasses.length * kModelsPerClass;

const visits = new Visits();

afterEach(() => {
    expect(visits.visitor.complaints).toEqual([]);
    expect(visits.visitor.strangers).toEqual([]);
});

describe('filters by numbers', () => {
    it('are opened by the keyboard, count truly, and survive a reload and the way back', async () => {
        const page = await visits.open('#/');
        await page.locator('.collection .card-link').first().waitFor();
        await page.locator('.more-filters > summary').focus();
        await page.keyboard.press('Enter');
        const branches = page.locator('.more-filters [name=branches]');
        await branches.waitFor();
        const options = await branches.locator('option').allTextContents();
        expect(options.length).toBeGreaterThan(2);
        const counts = options.slice(1).map((text) => Number(/\((\d+)\)$/.exec(text)?.[1]));
        expect(counts.reduce((sum, count) => sum + count, 0)).toBe(kModels);
        await branches.focus();
        await page.keyboard.press('ArrowDown');
        const shown = page.locator('.collection .count', { hasText: `${counts[0]}` });
        await shown.waitFor();
        await page.waitForURL(/#\/\?branches=[0-9]+-/);
        await page.reload();
        await shown.waitFor();
        expect(await branches.inputValue()).toMatch(/^[0-9]+-/);
        // Other counts follow the choice.
        const sides = page.locator('.more-filters [name=extent]');
        const sizes = (await sides.isVisible())
            ? await sides.locator('option').allTextContents()
            : [];
        const sum = sizes
            .slice(1)
            .reduce((all, text) => all + Number(/\((\d+)\)$/.exec(text)?.[1]), 0);
        expect([0, counts[0]]).toContain(sum);
        await page.locator('.collection .card-link').first().click();
        await page.locator('.hit-card').first().waitFor();
        await page.goBack();
        await shown.waitFor();
    });

    it('say where nothing fits', async () => {
        const page = await visits.open('#/?loops=17-');
        await page.getByText('No model fits these filters.').waitFor();
        expect(await page.locator('.more-filters [name=loops]').inputValue()).toBe('17-');
    });
});

describe('the order of hits', () => {
    it('is chosen by the keyboard, stands in the address and survives a reload', async () => {
        const page = await visits.open(`#/models/${kModels}`);
        await page
            .locator('.hit-card')
            .nth(kModels - 2)
            .waitFor();
        const names = () => page.locator('.hit-card .card-name').allTextContents();
        const nearest = await names();
        const order = page.locator('.hit-order select');
        await order.focus();
        await page.keyboard.press('ArrowDown');
        await page.waitForURL(/sort=name/);
        const sorted = [...nearest].sort((a, b) => a.localeCompare(b, 'en', { numeric: true }));
        // Cards come a few a frame.
        await expect.poll(names).toEqual(sorted);
        expect(await page.evaluate(() => document.activeElement?.getAttribute('name'))).toBe(
            'order',
        );
        await page.reload();
        await page.getByRole('list', { name: 'Hits by: Name' }).waitFor();
        await expect.poll(names).toEqual(sorted);
        // From hit to hit it goes in that order.
        await page.locator('.hit-card .card-link').first().click();
        await page.locator('dialog .match-table').waitFor();
        await page.getByRole('button', { name: 'Next hit' }).click();
        await page.locator('dialog h2', { hasText: sorted[1] ?? '' }).waitFor();
    });
});
