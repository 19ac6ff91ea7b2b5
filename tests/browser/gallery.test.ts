import type { BrowserContextOptions, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';

import { kClasses, kModelsPerClass } from './models';
import { changedPixels, looksOf, pictureOf, redShare, untilDrawn } from './pictures';
import { kPatienceMs } from './visitor';
import { Visits } from './visits';

const kModels = kClasses.length * kModelsPerClass;
const kSmall = { width: 1000, height: 480 };

const visits = new Visits();

async function open(hash = '#/', options: BrowserContextOptions = {}): Promise<Page> {
    return visits.open(hash, options);
}

async function upload(page: Page, file: string): Promise<void> {
    const chooser = page.waitForEvent('filechooser');
    await page.getByRole('button', { name: 'Choose a model' }).click();
    await (await chooser).setFiles(file);
}

function expectGoodManners(): void {
    expect(visits.visitor.complaints).toEqual([]);
    expect(visits.visitor.strangers).toEqual([]);
}

/** Presses Tab until the element that `selector` names has the focus. */
async function tabTo(page: Page, selector: string, most = 60): Promise<void> {
    for (let press = 0; press < most; press++) {
        await page.keyboard.press('Tab');
        if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) {
            return;
        }
    }
    throw new Error(`${selector} cannot be reached with ${most} presses of Tab`);
}

describe('the start page', () => {
    it('shows the whole collection with its pictures', async () => {
        const page = await open();
        await page
            .locator('.collection .card-link')
            .nth(kModels - 1)
            .waitFor();
        expect(await page.locator('.collection .card-link').count()).toBe(kModels);
        await page.locator('.thumbnail-ready').first().waitFor();
        const widths = await page
            .locator('.thumbnail-ready img')
            .evaluateAll((images) =>
                images.map((image) => (image as HTMLImageElement).naturalWidth),
            );
        expect(Math.min(...widths)).toBeGreaterThan(32);
        const thumbnail = await page.locator('.thumbnail-ready').first().screenshot();
        expect((await looksOf(thumbnail, page)).colors).toBeGreaterThan(3);
        expectGoodManners();
    });

    it('finds models by class, and keeps the filter in the address', async () => {
        const page = await open();
        await page.locator('.collection .card-link').first().waitFor();
        await page.locator('.filters option[value=cross]').waitFor({ state: 'attached' });
        await page.locator('.filters [name=class]').selectOption('cross');
        await page
            .locator('.collection .count', { hasText: new RegExp(`^${kModelsPerClass}$`) })
            .waitFor();
        expect(await page.locator('.collection .tag').allTextContents()).toEqual(
            Array(kModelsPerClass).fill('cross'),
        );
        await page.reload();
        await page
            .locator('.collection .count', { hasText: new RegExp(`^${kModelsPerClass}$`) })
            .waitFor();
        expect(await page.locator('.filters [name=class]').inputValue()).toBe('cross');
        expectGoodManners();
    });

    it('shows the code of an upload that is cut off, and still takes a good one', async () => {
        const page = await open();
        await upload(page, visits.collection.models.truncated);
        const code = page.locator('.notice-code');
        await code.waitFor();
        expect(await code.textContent()).toMatch(/^[a-z]+(_[a-z]+)+$/);
        expect(await code.textContent()).toContain('truncated');
        expect(page.url()).toBe(`${visits.collection.origin}/#/`);
        // The browser itself reports the refusal, and nothing else may be wrong.
        expect(visits.visitor.complaints.filter((text) => !text.includes('status of 4'))).toEqual(
            [],
        );
        await upload(page, visits.collection.models.query);
        await page.waitForURL('**/#/q/*');
        expect(visits.visitor.strangers).toEqual([]);
    });
});

describe('a search by upload', () => {
    it('leads to hits with pictures, to the 3D comparison and to the reports', async () => {
        const page = await open();
        await upload(page, visits.collection.models.query);
        await page.waitForURL('**/#/q/*');
        await page.locator('.hit-card').first().waitFor();
        expect(await page.locator('.hit-card').count()).toBe(kModels);
        expect(await page.locator('.hit-card .tag').first().textContent()).toBe('quadruped');
        await page.locator('.hit-card .thumbnail-ready').first().waitFor();
        const query = await pictureOf(page.locator('.query-picture canvas'));
        expect((await looksOf(query, page)).drawn).toBeGreaterThan(0.02);

        const saved = page.waitForEvent('download');
        await page.getByRole('button', { name: 'Save as CSV' }).click();
        expect((await saved).suggestedFilename()).toBe('like-query.csv');

        await page.locator('.hit-card a').first().click();
        await page.waitForURL('**/#/q/*/hits/*');
        const canvases = page.locator('dialog .pane-canvas');
        await canvases.nth(1).waitFor();
        expect(await canvases.count()).toBe(2);
        for (const canvas of await canvases.all()) {
            const { colors, drawn } = await looksOf(await pictureOf(canvas), page);
            expect(colors).toBeGreaterThan(5);
            expect(drawn).toBeGreaterThan(0.02);
        }
        expect(await page.locator('.match-table tbody tr').count()).toBeGreaterThan(0);
        expect(await page.locator('.parts-list dt').count()).toBeGreaterThan(0);

        await page.keyboard.press('Escape');
        await page.waitForURL('**/#/q/*');
        expect(await page.locator('dialog').count()).toBe(0);
        await page.getByRole('link', { name: 'Reports' }).click();
        await page.locator('.metrics-table tbody tr').nth(2).waitFor();
        const curve = await page.locator('.curve canvas').screenshot();
        expect((await looksOf(curve, page)).colors).toBeGreaterThan(5);
        expect(await page.locator('.confusion-table tbody tr').count()).toBe(kClasses.length);
        expect(await page.locator('.class-table tbody tr').count()).toBe(kClasses.length);
        expectGoodManners();
    });

    it('asks for other options without sending it again, and one step back leads away', async () => {
        const page = await open();
        await upload(page, visits.collection.models.query);
        await page.waitForURL('**/#/q/*');
        await page.locator('.hit-card').first().waitFor();
        const address = page.url();
        const [again] = await Promise.all([
            page.waitForResponse((response) => response.url().includes('/similar')),
            page.getByRole('radio', { name: 'Chain code' }).check(),
        ]);
        expect(again.request().method()).toBe('GET');
        expect(again.url()).toContain('ranker=chain-code');
        await page.waitForURL(`${address}?ranker=chain-code`);
        await page.getByRole('radio', { name: 'Skeleton' }).check();
        await page.waitForURL(`${address}?ranker=skeleton`);
        await page.goBack();
        await page.locator('.drop-zone').waitFor();
        await page.goForward();
        await page.locator('.hit-card').first().waitFor();
        expect(page.url()).toBe(`${address}?ranker=skeleton`);
        expectGoodManners();
    });

    it('survives a reload, and has parts and a pose', async () => {
        const page = await open();
        await upload(page, visits.collection.models.query);
        await page.waitForURL('**/#/q/*');
        await page.reload();
        await page.locator('.hit-card').first().waitFor();
        expect(await page.locator('.hit-card .tag').first().textContent()).toBe('quadruped');
        await page.getByRole('link', { name: 'Parts and pose' }).click();
        await page.locator('.part-legend tbody tr').nth(2).waitFor();
        await untilDrawn(page.locator('dialog .pane-canvas'));
        expect(await page.locator('.joint-handle').count()).toBeGreaterThan(3);
        expectGoodManners();
    });
});

describe('the 3D comparison', () => {
    async function openComparison(): Promise<Page> {
        // Software rendering takes its time over each pixel.
        const page = await open(`#/models/${kModels}`, { viewport: kSmall });
        await page.locator('.hit-card a').first().click();
        await page.locator('.match-table tbody tr').first().waitFor();
        return page;
    }

    it('lights up a branch in both pictures when its row is pointed at', async () => {
        const page = await openComparison();
        const canvases = await page.locator('dialog .pane-canvas').all();
        const pictures = async () => {
            const found: Buffer[] = [];
            for (const canvas of canvases) {
                found.push(await pictureOf(canvas));
            }
            return found;
        };
        await page.locator('.match-summary').hover();
        const before = await pictures();
        const row = page.locator('.match-table tbody tr').first();
        // Whole, wherever the table begins: what is cut off by half counts as visible already.
        await row.evaluate((node) => {
            node.scrollIntoView({ block: 'center' });
        });
        await row.hover();
        await page.locator('.match-table tr.chosen').waitFor();
        const during = await pictures();
        await page.locator('.match-summary').hover();
        await page.locator('.match-table tr.chosen').waitFor({ state: 'detached' });
        const after = await pictures();
        expect(before).toHaveLength(2);
        for (const [at, picture] of before.entries()) {
            expect(await changedPixels(picture, during[at] as Buffer, page)).toBeGreaterThan(0);
            expect(await changedPixels(picture, after[at] as Buffer, page)).toBe(0);
        }
        expectGoodManners();
    });

    it('turns both models by dragging one, and one alone on demand', async () => {
        const page = await openComparison();
        const [left, right] = await page.locator('dialog .pane-canvas').all();
        if (!left || !right) {
            throw new Error('there are no two pictures');
        }
        const drag = async () => {
            const frame = await left.boundingBox();
            const x = (frame?.x ?? 0) + 30;
            const y = (frame?.y ?? 0) + (frame?.height ?? 0) - 40;
            await page.mouse.move(x, y);
            await page.mouse.down();
            await page.mouse.move(x + 90, y, { steps: 4 });
            await page.mouse.up();
            await page.locator('.match-summary').hover();
        };
        const still = await pictureOf(right);
        await drag();
        const together = await pictureOf(right);
        expect(await changedPixels(still, together, page)).toBeGreaterThan(0);
        await page.getByLabel('Turn together').uncheck();
        const alone = await pictureOf(left);
        await drag();
        expect(await changedPixels(alone, await pictureOf(left), page)).toBeGreaterThan(0);
        expect(await changedPixels(together, await pictureOf(right), page)).toBe(0);
        expectGoodManners();
    });

    it('stands a model on another of its axes, and that one alone', async () => {
        const page = await openComparison();
        const [left, right] = await page.locator('dialog .pane-canvas').all();
        if (!left || !right) {
            throw new Error('there are no two pictures');
        }
        const axis = (name: string) =>
            page.locator('dialog .up-control').first().getByRole('button', { name });
        const pictures = async () => {
            await page.locator('.match-summary').hover();
            return [await pictureOf(left), await pictureOf(right)] as const;
        };
        const before = await pictures();
        await axis('z up').click();
        const turned = await pictures();
        expect(await changedPixels(before[0], turned[0], page)).toBeGreaterThan(0);
        expect(await changedPixels(before[1], turned[1], page)).toBe(0);
        await axis('y up').click();
        expect(await changedPixels(before[0], (await pictures())[0], page)).toBe(0);
        expectGoodManners();
    });

    it('keeps its tables where there is no WebGL', async () => {
        const page = await visits.come();
        await page.addInitScript(() => {
            HTMLCanvasElement.prototype.getContext = () => null;
        });
        await page.goto(`${visits.collection.origin}/#/models/${kModels}`);
        await page.locator('.hit-card a').first().click();
        await page.locator('dialog .no-webgl').waitFor();
        expect(await page.locator('.match-table tbody tr').count()).toBeGreaterThan(0);
        expectGoodManners();
    });
});

describe('a model whose file has colours', () => {
    it('is shown in them, and without them by a switch', async () => {
        const page = await open('#/', { viewport: kSmall });
        await upload(page, visits.collection.models.painted);
        const canvas = page.locator('.query-picture canvas');
        await canvas.waitFor({ timeout: kPatienceMs });
        const painted = await pictureOf(canvas);
        const control = page.locator('.query-picture').getByLabel('Colours of the file');
        expect(await control.isChecked()).toBe(true);
        expect(await redShare(painted, page)).toBeGreaterThan(0.05);
        await control.uncheck();
        const plain = await pictureOf(canvas);
        expect(await redShare(plain, page)).toBeLessThan(0.01);
        expect(await page.locator('.query .facts').textContent()).toContain('×');
        expectGoodManners();
    });

    it('has no such switch where the file has none', async () => {
        const page = await open(`#/models/${kModels}`, { viewport: kSmall });
        await untilDrawn(page.locator('.query-picture canvas'));
        expect(await page.locator('.color-control').count()).toBe(0);
    });
});

describe('a model that says which of its axes points up', () => {
    it.each(['y', 'z'])('stands upright on %s, alone, compared and in parts', async (up) => {
        const page = await open(`#/models/${kModels}`, { viewport: kSmall });
        await page.route(/\/v1\/models\/\d+$/, async (route) => {
            const response = await route.fetch();
            await route.fulfill({ response, json: { ...(await response.json()), up } });
        });
        await page.reload();
        const said = (place: string) =>
            page.locator(`${place} .up-control [aria-pressed=true]`).allTextContents();
        await untilDrawn(page.locator('.query-picture canvas'));
        expect(await said('.query-picture')).toEqual([`${up} up`]);
        await page.locator('.hit-card a').first().click();
        await untilDrawn(page.locator('dialog .pane-canvas').last());
        expect(await said('dialog')).toEqual([`${up} up`, `${up} up`]);
        await page.keyboard.press('Escape');
        await page.locator('dialog').waitFor({ state: 'detached' });
        await page.getByRole('link', { name: 'Parts and pose' }).click();
        await untilDrawn(page.locator('dialog .pane-canvas'));
        expect(await said('dialog')).toEqual([`${up} up`]);
        expectGoodManners();
    });
});

describe('the parts of a model', () => {
    async function openParts(): Promise<Page> {
        const page = await open(`#/models/${kModels}`, { viewport: kSmall });
        await page.getByRole('link', { name: 'Parts and pose' }).click();
        await page.locator('.part-legend tbody tr').first().waitFor();
        return page;
    }

    /** What is drawn, without the buttons over it. */
    async function modelIn(page: Page): Promise<Buffer> {
        const joints = page.getByRole('checkbox', { name: 'Joints' });
        await joints.uncheck();
        await page.locator('.match-summary').hover();
        const picture = await pictureOf(page.locator('dialog .pane-canvas'));
        await joints.check();
        return picture;
    }

    it('are coloured and listed on demand', async () => {
        const page = await openParts();
        const shares = await page.locator('.part-legend td.number').allTextContents();
        expect(shares.length).toBeGreaterThan(3);
        const sum = shares.reduce((total, share) => total + Number.parseFloat(share), 0);
        expect(Math.abs(sum - 100)).toBeLessThan(0.06 * shares.length);
        const picture = async () => {
            await page.locator('.match-summary').hover();
            return pictureOf(page.locator('dialog .pane-canvas'));
        };
        const colored = await picture();
        const looks = await looksOf(colored, page);
        expect(looks.drawn).toBeGreaterThan(0.02);
        await page.getByRole('checkbox', { name: 'Parts' }).uncheck();
        expect((await looksOf(await picture(), page)).colors).toBeLessThan(looks.colors);
        await page.getByRole('checkbox', { name: 'Parts' }).check();
        expect(await changedPixels(colored, await picture(), page)).toBe(0);
        expectGoodManners();
    });

    it('move with the joint that is dragged, and go back', async () => {
        const page = await openParts();
        const rest = await modelIn(page);
        const joint = page.locator('.joint-handle').last();
        const place = async () => {
            await untilDrawn(page.locator('dialog .pane-canvas'));
            const box = await joint.boundingBox();
            return { x: (box?.x ?? 0) + 12, y: (box?.y ?? 0) + 12 };
        };
        const from = await place();
        await page.mouse.move(from.x, from.y);
        await page.mouse.down();
        const to = { x: from.x + 12, y: from.y - 30 };
        await page.mouse.move(to.x, to.y, { steps: 5 });
        await page.mouse.up();
        const dragged = await place();
        expect(Math.hypot(dragged.x - from.x, dragged.y - from.y)).toBeGreaterThan(8);
        const posed = await modelIn(page);
        expect(await changedPixels(rest, posed, page)).toBeGreaterThan(0);
        expect(page.url()).toContain('posed=');
        await page.getByRole('button', { name: 'Undo' }).click();
        expect(await changedPixels(rest, await modelIn(page), page)).toBe(0);
        expect(page.url()).not.toContain('posed=');
        await page.getByRole('button', { name: 'Redo' }).click();
        expect(await changedPixels(posed, await modelIn(page), page)).toBe(0);
        await page.getByRole('button', { name: 'Reset pose' }).click();
        expect(await changedPixels(rest, await modelIn(page), page)).toBe(0);
        const back = await place();
        expect(Math.hypot(back.x - from.x, back.y - from.y)).toBeLessThan(1);
        expectGoodManners();
    });

    it('move with the keyboard', async () => {
        const page = await openParts();
        const rest = await modelIn(page);
        await page.locator('.joint-handle').last().focus();
        for (let press = 0; press < 4; press++) {
            await page.keyboard.press('ArrowUp');
        }
        await page.keyboard.press('ArrowLeft');
        expect(await changedPixels(rest, await modelIn(page), page)).toBeGreaterThan(0);
        await page.locator('.joint-handle').last().focus();
        await page.keyboard.press('Home');
        expect(await changedPixels(rest, await modelIn(page), page)).toBe(0);
        await page.keyboard.press('Escape');
        await page.locator('dialog').waitFor({ state: 'detached' });
        expect(page.url()).toBe(`${visits.collection.origin}/#/models/${kModels}`);
        expectGoodManners();
    });

    it('are missed with a reason where the server cannot give them', async () => {
        const page = await open(`#/models/${kModels}`, { viewport: kSmall });
        await page.route('**/rig.glb', (route) =>
            route.fulfill({
                status: 404,
                contentType: 'application/problem+json',
                body: JSON.stringify({
                    title: 'No decomposition',
                    status: 404,
                    code: 'segments_not_available',
                }),
            }),
        );
        await page.getByRole('link', { name: 'Parts and pose' }).click();
        await page.locator('dialog .notice-code').waitFor();
        expect(await page.locator('dialog .notice-code').textContent()).toBe(
            'segments_not_available',
        );
        await page.unroute('**/rig.glb');
        await page.getByRole('button', { name: 'Try again' }).click();
        await page.locator('.part-legend tbody tr').first().waitFor();
        expect(visits.visitor.strangers).toEqual([]);
    });
});

describe('without a mouse', () => {
    it('leads from the collection to a comparison and back', async () => {
        const page = await open('#/', { viewport: kSmall });
        await page.locator('.collection .card-link').first().waitFor();
        await tabTo(page, '.collection .card-link');
        await page.keyboard.press('Enter');
        await page.locator('.hit-card').first().waitFor();
        await tabTo(page, '.hit-card a');
        await page.keyboard.press('Enter');
        await page.locator('.match-table tbody tr').first().waitFor();
        const canvas = page.locator('dialog .pane-canvas').first();
        await tabTo(page, 'dialog .pane-canvas');
        const before = await pictureOf(canvas);
        await page.keyboard.press('ArrowRight');
        expect(await changedPixels(before, await pictureOf(canvas), page)).toBeGreaterThan(0);
        await tabTo(page, '.match-table tbody button');
        await page.locator('.match-table tr.chosen').waitFor();
        await page.keyboard.press('Escape');
        await page.locator('dialog').waitFor({ state: 'detached' });
        expect(await page.evaluate(() => document.activeElement?.matches('.hit-card a'))).toBe(
            true,
        );
        expectGoodManners();
    });

    it('uploads a model', async () => {
        const page = await open();
        const chooser = page.waitForEvent('filechooser');
        await tabTo(page, '.drop-zone button');
        await page.keyboard.press('Enter');
        await (await chooser).setFiles(visits.collection.models.query);
        await page.waitForURL('**/#/q/*');
        await page.locator('.hit-card').first().waitFor();
        expectGoodManners();
    });
});

describe('any page', () => {
    it.each([
        ['#/', '.collection .card-link'],
        [`#/models/${kModels}`, '.hit-card'],
        [`#/models/${kModels}/parts`, '.part-legend'],
        ['#/reports', '.confusion-table'],
        ['#/nowhere', '.notice'],
    ])('%s fits a narrow screen, light and dark', async (hash, ready) => {
        for (const colorScheme of ['light', 'dark'] as const) {
            const page = await open(hash, { viewport: { width: 360, height: 740 }, colorScheme });
            await page.locator(ready).first().waitFor();
            const overflow = await page.evaluate(
                () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
            );
            expect(overflow).toBe(0);
            expectGoodManners();
            await visits.visitor.close();
        }
    });
});
