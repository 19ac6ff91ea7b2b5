import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';

import { type WrittenModels, writeModels } from './models';
import { buildIndex, type Server, type ServerSetting, startServer } from './server';
import { launchBrowser } from './visitor';

/** A small collection that is served, and a browser to look at it with. */
export interface ServedCollection {
    models: WrittenModels;
    /** As in http://127.0.0.1:40123 */
    origin: string;
    browser: Browser;
    stop(): Promise<void>;
}

export async function serveCollection(setting: ServerSetting = {}): Promise<ServedCollection> {
    const folder = mkdtempSync(join(tmpdir(), 'ossuary-browser-'));
    const models = writeModels(folder);
    let server: Server | undefined;
    let browser: Browser | undefined;
    const stop = async () => {
        await browser?.close();
        await server?.stop();
        rmSync(folder, { recursive: true, force: true });
    };
    try {
        const index = join(folder, 'collection.ossuary');
        buildIndex(index, models.folder, models.classes);
        server = await startServer(index, setting);
        browser = await launchBrowser();
        return { models, origin: server.origin, browser, stop };
    } catch (error) {
        await stop();
        throw error;
    }
}
