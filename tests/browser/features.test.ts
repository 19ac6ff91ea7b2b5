import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { afterEach, describe, expect, it } from 'vitest';

import { kClasses, kModelsPerClass } from './models';
import { changedPixels, pictureOf, untilDrawn } from './pictures';
import { kAdminKey } from './server';
import { Visits } from './visits';

const kModels = kClasses.length * kModelsPerClass;
const kSmall = { width: 1000, height: 480 };

const visits = new Visits();

afterEach(() => {
    expect(visits.visitor.complaints).toEqual([]);
    expect(visits.visitor.strangers).toEqual([]);
});

describe('models that are ticked', () => {
    it('are compared two by two, saved as a list, and ticked still after a reload', async () => {
        const page = await visits.open('#/');
        await page.locator('.card-check input').first().check();
        await page
            .locator('.card-check input')
            .nth(kModels - 1)
            .check();
        const saved = page.waitForEvent('download');
        await page.getByRole('button', { name: 'Save the list' }).click();
        expect((await saved).suggestedFilename()).toBe('models.csv');
        await page.reload();
        await page.locator('.selection-bar').getByText('2 selected').waitFor();
        await page.getByRole('link', { name: 'Compare' }).click();
        await page.locator('dialog .match-table').waitFor();
        expect(page.url()).toMatch(/#\/models\/\d+\/hits\/\d+$/);
    });
});

describe('a part of a model', () => {
    it('finds the models that have it', async () => {
        const page = await visits.open(`#/models/${kModels}/parts`, { viewport: kSmall });
        await page.getByRole('button', { name: 'Find models with part 2' }).click();
        await page.waitForURL('**/#/q/*part=true*');
        await page.locator('.hit-card').first().waitFor();
        expect(await page.locator('.results-title').textContent()).toContain('part 2');
        expect(await page.locator('.hit-card').count()).toBeGreaterThan(1);
    });
});

describe('a closer look', () => {
    async function look(): Promise<Page> {
        const page = await visits.open(`#/models/${kModels}/look`, { viewport: kSmall });
        await untilDrawn(page.locator('dialog .pane-canvas'));
        return page;
    }

    it('cuts, draws edges and box, and saves what it shows', async () => {
        const page = await look();
        const canvas = page.locator('dialog .pane-canvas');
        let before = await pictureOf(canvas);
        await page.locator('.look-more summary').click();
        for (const change of [
            () => page.getByLabel('Wireframe').check(),
            () => page.getByLabel('Bounding box').check(),
            () => page.getByLabel('Cut across').selectOption('0'),
            () => page.getByLabel('View from').selectOption('Top'),
            () => page.getByLabel('Orthographic').check(),
            () => page.getByLabel('Opacity').fill('1'),
        ]) {
            await change();
            const after = await pictureOf(canvas);
            expect(await changedPixels(before, after, page)).toBeGreaterThan(0);
            before = after;
        }
        const saved = page.waitForEvent('download');
        await page.getByRole('button', { name: 'Save picture' }).click();
        expect((await saved).suggestedFilename()).toMatch(/^\w+\.png$/);
    });

    it('measures between two points, with the keyboard too', async () => {
        const page = await look();
        await page.getByLabel('Measure', { exact: true }).check();
        await page.locator('dialog .pane-canvas').focus();
        await page.keyboard.press('Home');
        await page.keyboard.press('Enter');
        for (let press = 0; press < 3; press++) {
            await page.keyboard.press('ArrowRight');
        }
        await untilDrawn(page.locator('dialog .pane-canvas'));
        await page.keyboard.press('Enter');
        const length = page.locator('.look-said', { hasText: /: [0-9.]+$/ });
        await length.waitFor();
        expect(Number(/[0-9.]+$/.exec((await length.textContent()) ?? '')?.[0])).toBeGreaterThan(0);
    });
});

describe('who has the key', () => {
    it('adds a model and takes its removal back', async () => {
        const page = await visits.open('#/manage');
        await page.locator('input[name=key]').fill(kAdminKey);
        await page.keyboard.press('Enter');
        await page.locator('.failures').getByText('broken.off').first().waitFor();
        await page
            .locator('.manage-form input[type=file]')
            .first()
            .setInputFiles(visits.collection.models.painted);
        await page.locator('.added-models a', { hasText: 'is in the collection' }).click();
        await page.locator('.hit-card').first().waitFor();
        await page.locator('.card-check input').first().check();
        await page.getByRole('link', { name: 'Manage' }).click();
        await page.getByRole('button', { name: 'Remove them' }).click();
        await page.getByRole('button', { name: 'Undo' }).click();
        await page.getByText('Nothing was removed.').waitFor();
        // Its job stands in the list from here and elsewhere, after a reload too.
        await page.reload();
        await page.locator('.jobs tbody tr', { hasText: 'painted' }).first().waitFor();
    });

    it('sees what somebody else adds, and why it fails', async () => {
        const page = await visits.open('#/manage');
        await page.locator('input[name=key]').fill(kAdminKey);
        await page.keyboard.press('Enter');
        await page.locator('.jobs').waitFor();
        const added = await page.request.post(
            `${visits.collection.origin}/v1/models?name=from-elsewhere&class=angle`,
            {
                headers: { Authorization: `Bearer ${kAdminKey}`, 'Content-Type': 'model/off' },
                data: readFileSync(visits.collection.models.query),
            },
        );
        expect(added.status()).toBe(202);
        const row = page.locator('.jobs tbody tr', { hasText: 'from-elsewhere' });
        await row.first().waitFor();
        await row.getByRole('link', { name: 'is in the collection' }).first().waitFor();
        expect(await row.first().textContent()).toContain('angle');
    });
});

describe('the language', () => {
    it('is the browser’s, until another is chosen', async () => {
        const page = await visits.open('#/', { locale: 'de-AT' });
        await page.getByRole('link', { name: 'Suche', exact: true }).waitFor();
        expect(await page.locator('html').getAttribute('lang')).toBe('de');
        await page.locator('.language').selectOption('en');
        await page.getByRole('link', { name: 'Search', exact: true }).waitFor();
        await page.reload();
        await page.getByRole('link', { name: 'Search', exact: true }).waitFor();
    });
});
