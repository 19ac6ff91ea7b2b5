import type { Page } from 'playwright-core';
import { afterEach, describe, expect, it } from 'vitest';

import { box, off } from './models';
import { Visits } from './visits';

const visits = new Visits();

afterEach(() => {
    expect(visits.visitor.complaints).toEqual([]);
});

/** Bars across each other: what a search has work with. */
function lattice(bars: number): Buffer {
    const places = Array.from({ length: bars * bars }, (_, at) => [
        at % bars,
        Math.floor(at / bars),
    ]);
    return Buffer.from(
        off(
            places.flatMap(([x = 0, y = 0]) => [
                box([x, y, 0], [x + 0.3, y + 0.3, bars]),
                box([x, 0, y], [x + 0.3, bars, y + 0.3]),
                box([0, x, y], [bars, x + 0.3, y + 0.3]),
            ]),
        ),
    );
}

/** Notes all that the bar says from now on. */
async function watchBar(page: Page): Promise<void> {
    await page.evaluate(() => {
        const said: string[] = [];
        Object.assign(globalThis, { said });
        new MutationObserver(() => {
            const text = document.querySelector('.progress-line span')?.textContent;
            if (text && said.at(-1) !== text) {
                said.push(text);
            }
        }).observe(document.body, { subtree: true, childList: true, characterData: true });
    });
}

/** Presses Cancel as soon as the bar names a step: no hand is quick enough for every machine. */
async function cancelAtFirstStep(page: Page): Promise<void> {
    await page.evaluate(() => {
        const observer = new MutationObserver(() => {
            const text = document.querySelector('.progress-line span')?.textContent ?? '';
            const buttons = document.querySelectorAll<HTMLElement>('.progress button');
            const cancel = [...buttons].find((button) => button.textContent === 'Cancel');
            if (/step \d+ of 12/.test(text) && cancel) {
                observer.disconnect();
                Object.assign(globalThis, { cancelled: text });
                cancel.click();
            }
        });
        observer.observe(document.body, { subtree: true, childList: true, characterData: true });
    });
}

async function begin(page: Page, bars: number): Promise<{ token: string }> {
    await watchBar(page);
    const asked = page.waitForRequest('**/v1/search?*');
    const file = { name: 'lattice.off', mimeType: 'text/plain', buffer: lattice(bars) };
    await page.locator('.header input[type=file]').setInputFiles(file);
    const token = new URL((await asked).url()).searchParams.get('progress') ?? '';
    expect(token).toMatch(/^[0-9a-f]{32}$/);
    return { token };
}

describe('a search with an upload', () => {
    it('says which stage the server is in, until the hits are there', async () => {
        const page = await visits.open('#/');
        await page.locator('.collection .card-link').first().waitFor();
        await begin(page, 9);
        const bar = page.getByRole('progressbar');
        await page.locator('.progress-line', { hasText: /step \d+ of 12/ }).waitFor();
        expect(await bar.getAttribute('aria-valuetext')).toContain('lattice.off');
        await page.locator('.hit-card').first().waitFor();
        const said = await page.evaluate(() => (globalThis as unknown as { said: string[] }).said);
        const steps = said.flatMap((text) => {
            const step = /step (\d+) of 12/.exec(text)?.[1];
            return step ? [Number(step)] : [];
        });
        expect(steps.length).toBeGreaterThan(1);
        expect(steps).toEqual([...steps].sort((a, b) => a - b));
        expect(await bar.count()).toBe(0);
    });

    it('is given up by the server once it is cancelled', async () => {
        const page = await visits.open('#/');
        await page.locator('.collection .card-link').first().waitFor();
        await cancelAtFirstStep(page);
        const { token } = await begin(page, 14);
        await expect
            .poll(() => page.evaluate(() => (globalThis as { cancelled?: string }).cancelled))
            .toMatch(/step \d+ of 12/);
        await page.locator('.progress').waitFor({ state: 'detached' });
        const stage = async (): Promise<unknown> => {
            const { origin } = visits.collection;
            return (await (await page.request.get(`${origin}/v1/progress/${token}`)).json()).stage;
        };
        // It looks for that every few milliseconds of its work.
        await expect.poll(stage, { timeout: 20_000 }).toBeNull();
        expect(page.url()).toMatch(/#\/$/);
        expect(await page.locator('.card-link').count()).toBeGreaterThan(0);
    });
});
