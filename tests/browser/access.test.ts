import { afterAll, beforeAll, expect, it } from 'vitest';

import { type ServedCollection, serveCollection } from './collection';
import { kReadKey } from './server';
import { type Visitor, visit } from './visitor';

let collection: ServedCollection;
let visitor: Visitor | undefined;

beforeAll(async () => {
    collection = await serveCollection({
        options: ['--base-path', '/shop/models'],
        environment: { OSSUARY_READ_KEY: kReadKey },
    });
});

afterAll(async () => {
    await visitor?.close();
    await collection.stop();
});

it('works below a path of a site, for people with the key', async () => {
    visitor = await visit(collection.browser, collection.origin, {
        httpCredentials: { username: 'anna', password: kReadKey, origin: collection.origin },
    });
    const { page, complaints, strangers } = visitor;
    const paths: string[] = [];
    page.on('request', (request) => paths.push(new URL(request.url()).pathname));
    await page.goto(`${collection.origin}/shop/models`);
    expect(page.url()).toBe(`${collection.origin}/shop/models/`);
    await page.locator('.thumbnail-ready').first().waitFor();
    await page.getByRole('button', { name: 'Choose a model' }).waitFor();
    const chooser = page.waitForEvent('filechooser');
    await page.getByRole('button', { name: 'Choose a model' }).click();
    await (await chooser).setFiles(collection.models.query);
    await page.locator('.hits .card-link').first().waitFor();
    await page.locator('.hits .thumbnail-ready').first().waitFor();
    expect(paths.filter((path) => !path.startsWith('/shop/models'))).toEqual([]);
    expect(paths.some((path) => path.startsWith('/shop/models/v1/search'))).toBe(true);
    expect(complaints.filter((text) => !text.includes('status of 401'))).toEqual([]);
    expect(strangers).toEqual([]);
});

it('shows nothing to people without it', async () => {
    const stranger = await visit(collection.browser, collection.origin);
    // There is nobody to type the key that the browser asks for.
    await expect(stranger.page.goto(`${collection.origin}/shop/models/`)).rejects.toThrow(/AUTH/);
    expect(await stranger.page.locator('.card-link').count()).toBe(0);
    await stranger.close();
});
