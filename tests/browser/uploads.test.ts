import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';

import { Visits } from './visits';

const visits = new Visits();

async function open(hash: string): Promise<Page> {
    return visits.open(hash);
}

function expectGoodManners(): void {
    expect(visits.visitor.complaints).toEqual([]);
    expect(visits.visitor.strangers).toEqual([]);
}

/** What a browser does when files are let go over `selector`, or pasted there. */
async function give(page: Page, type: 'drop' | 'paste', selector: string, names: string[]) {
    const text = readFileSync(visits.collection.models.query, 'utf8');
    await page.locator(selector).first().waitFor();
    return page.evaluate(
        ([event, where, model, list]) => {
            const held = new DataTransfer();
            for (const name of list) {
                held.items.add(new File([model], name));
            }
            const options = { bubbles: true, cancelable: true };
            const given =
                event === 'drop'
                    ? new DragEvent('drop', { ...options, dataTransfer: held })
                    : new ClipboardEvent('paste', { ...options, clipboardData: held });
            document.querySelector(where)?.dispatchEvent(given);
            return given.defaultPrevented;
        },
        [type, selector, text, names] as const,
    );
}

/** Waits for something that happens elsewhere. */
function signal(): { given: Promise<void>; give: () => void } {
    let give: () => void = () => {};
    const given = new Promise<void>((resolve) => {
        give = resolve;
    });
    return { given, give };
}

it.each([
    ['#/', '.card-link'],
    ['#/models/1', '.hit-card'],
    ['#/models/1/hits/2', '.match-table'],
    ['#/reports', '.metrics-table'],
    ['#/nowhere', '.notice'],
])('a file that is dropped on %s is searched with, whatever lies under it', async (hash, under) => {
    const page = await open(hash);
    expect(await give(page, 'drop', under, ['new.off'])).toBe(true);
    await page.waitForURL('**/#/q/*');
    await page.getByRole('heading', { name: 'Models like new' }).waitFor();
    expect(await page.locator('dialog').count()).toBe(0);
    expect(await page.title()).toBe('Models like new · Ossuary');
    expectGoodManners();
});

it('a file that is pasted is searched with', async () => {
    const page = await open('#/models/1');
    expect(await give(page, 'paste', '.hit-card', ['pasted.off'])).toBe(true);
    await page.getByRole('heading', { name: 'Models like pasted' }).waitFor();
    expectGoodManners();
});

it('several files become a row, each with its results', async () => {
    const page = await open('#/reports');
    await give(page, 'drop', '.reports', ['one.off', 'two.off', 'three.off']);
    await page.locator('.chip a').nth(2).waitFor();
    await page.getByRole('heading', { name: 'Models like one' }).waitFor();
    await page.getByRole('link', { name: 'three.off' }).click();
    await page.getByRole('heading', { name: 'Models like three' }).waitFor();
    await page.reload();
    await page.getByRole('heading', { name: 'Models like three' }).waitFor();
    await page.getByRole('link', { name: 'two.off' }).click();
    await page.getByRole('heading', { name: 'Models like two' }).waitFor();
    expectGoodManners();
});

it('a file that changed on the disk before it was sent is named as what is wrong', async () => {
    const page = await open('#/models/1');
    const paths = ['first.off', 'changed.off'].map((name) =>
        join(visits.collection.models.folder, '..', name),
    );
    for (const path of paths) {
        writeFileSync(path, readFileSync(visits.collection.models.query));
    }
    // The first holds the others up until the second is another one on the disk.
    const sent = signal();
    const go = signal();
    await page.route('**/v1/search*', async (route) => {
        sent.give();
        await go.given;
        await route.continue();
    });
    await page.locator('.header input[type=file]').setInputFiles(paths);
    await sent.given;
    writeFileSync(paths[1] as string, 'OFF\n0 0 0\n');
    go.give();
    const problem = page.locator('.upload-problem');
    await problem.waitFor();
    expect(await problem.locator('.notice-code').textContent()).toBe('local_file');
    expect(await problem.textContent()).toContain('changed.off');
    await problem.getByRole('button').click();
    await problem.waitFor({ state: 'detached' });
    expect(visits.visitor.strangers).toEqual([]);
});

it('an upload that the server has forgotten is sent again by the page that has it', async () => {
    const page = await open('#/');
    await give(page, 'drop', '.drop-zone', ['kept.off']);
    await page.waitForURL('**/#/q/*');
    await page.locator('.hit-card').first().waitFor();
    const before = page.url();
    const gone = JSON.stringify({ title: 'Gone', status: 404, code: 'query_not_found' });
    const forget = { status: 404, contentType: 'application/problem+json', body: gone };
    await page.route(`**${new URL(before).hash.replace('#/q', '/v1/queries')}/**`, (route) =>
        route.fulfill(forget),
    );
    await page.getByRole('radio', { name: 'Skeleton' }).check();
    await page.waitForURL(
        (url) => url.hash.startsWith('#/q/') && !before.includes(url.hash.slice(4, 36)),
    );
    await page.locator('.hit-card').first().waitFor();
    expect(visits.visitor.strangers).toEqual([]);
});
