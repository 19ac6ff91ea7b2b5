import type { Page } from 'playwright-core';
import { afterEach, expect, it } from 'vitest';

import { Visits } from './visits';

const kTotal = 100_000;

const visits = new Visits();

afterEach(() => {
    expect(visits.visitor.complaints).toEqual([]);
});

/** The real server's first model as each of a hundred thousand. */
async function open(hash = '#/'): Promise<{ page: Page; asked: URL[] }> {
    const page = await visits.come();
    const asked: URL[] = [];
    const response = await page.request.get(`${visits.collection.origin}/v1/models?limit=1`);
    const [model] = (await response.json()).models;
    await page.route('**/v1/models?*', (route) => {
        const url = new URL(route.request().url());
        asked.push(url);
        const number = (name: string) => Number(url.searchParams.get(name));
        const total = url.searchParams.has('name') ? 1 : kTotal;
        const count = Math.max(0, Math.min(number('limit'), total - number('offset')));
        const models = Array.from({ length: count }, (_, at) => {
            const id = number('offset') + at + 1;
            return { ...model, id, name: `model ${id}` };
        });
        return route.fulfill({ json: { models, next_cursor: null, total, revision: 1 } });
    });
    await page.goto(`${visits.collection.origin}/${hash}`);
    await page.locator('.virtual-grid .card-link').first().waitFor();
    return { page, asked };
}

/** Names of the cards that are within the window. */
function inSight(page: Page): Promise<string[]> {
    return page.evaluate(() =>
        [...document.querySelectorAll('.virtual-grid .card-name')]
            .filter((name) => {
                const { top, bottom } = name.getBoundingClientRect();
                return bottom > 0 && top < innerHeight;
            })
            .map((name) => name.textContent ?? ''),
    );
}

it('shows any place of a hundred thousand models with a handful of cards', async () => {
    const { page, asked } = await open();
    for (const share of [0.25, 0.5, 0.999, 0.1]) {
        await page.evaluate((wanted) => scrollTo(0, wanted * document.body.scrollHeight), share);
        await page.waitForFunction(
            ([total, wanted]) => {
                const shown = [...document.querySelectorAll('.virtual-grid .card-name')].map(
                    (name) => Number(/\d+/.exec(name.textContent ?? '')?.[0]),
                );
                const about = Number(total) * Number(wanted);
                return shown.some((id) => Math.abs(id - about) < 0.02 * Number(total));
            },
            [kTotal, share],
        );
        expect(await page.locator('.virtual-grid > li').count()).toBeLessThan(150);
    }
    // What was only passed is never asked for.
    expect(asked.length).toBeLessThan(25);
});

it('keeps its place in the address, over a reload and from a link', async () => {
    const { page } = await open();
    await page.evaluate(() => scrollTo(0, 0.5 * document.body.scrollHeight));
    await page.waitForURL('**/#/?at=*');
    const at = Number(/at=(\d+)/.exec(page.url())?.[1]);
    expect(Math.abs(at - kTotal / 2)).toBeLessThan(0.02 * kTotal);
    await page.reload();
    await page.getByText(`model ${at + 1}`, { exact: true }).waitFor();
    expect(await inSight(page)).toContain(`model ${at + 1}`);
});

it('is walked by the keyboard in its order', async () => {
    const { page } = await open();
    await page.locator('.virtual-grid .card-link').first().focus();
    const walked: string[] = [];
    // Between two cards lies what ticks the first.
    for (let step = 0; step < 60; step++) {
        const name = await page.evaluate(
            () => document.activeElement?.querySelector('.card-name')?.textContent ?? null,
        );
        if (name !== null) walked.push(name);
        await page.keyboard.press('Tab');
    }
    expect(walked).toEqual(Array.from({ length: 30 }, (_, at) => `model ${at + 1}`));
});

it('says where the hand is that a page did not arrive, and asks again', async () => {
    const { page } = await open();
    await page.route('**/v1/models?*offset=5*', (route) => route.abort());
    await page.evaluate(() => scrollTo(0, 0.55 * document.body.scrollHeight));
    const notice = page.locator('.grid-problem .notice');
    await notice.waitFor();
    const box = await notice.boundingBox();
    expect(box?.y).toBeGreaterThan(0);
    expect(box?.y).toBeLessThan(860);
    await page.unroute('**/v1/models?*offset=5*');
    await notice.getByRole('button', { name: 'Try again' }).click();
    await notice.waitFor({ state: 'detached' });
    await page.waitForFunction(() =>
        [...document.querySelectorAll('.virtual-grid .card-name')].some((name) =>
            /model 5\d{4}/.test(name.textContent ?? ''),
        ),
    );
    visits.visitor.complaints.length = 0;
});

it('finds a model by its name as one types', async () => {
    const { page } = await open();
    await page.locator('.filters [name=name]').fill('x');
    await page.locator('.collection .count', { hasText: /^1$/ }).waitFor();
    expect(await page.locator('.virtual-grid .card-link').count()).toBe(1);
});
