import type { BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll } from 'vitest';

import { type ServedCollection, serveCollection } from './collection';
import { type Visitor, visit } from './visitor';

/** A collection that is served to all tests of a file; each test's visitor leaves after it. */
export class Visits {
    private collection_: ServedCollection | undefined;
    private visitor_: Visitor | undefined;

    constructor() {
        beforeAll(async () => {
            this.collection_ = await serveCollection();
        });
        afterAll(() => this.collection_?.stop());
        afterEach(() => this.visitor_?.close());
    }

    get collection(): ServedCollection {
        if (!this.collection_) {
            throw new Error('the collection is served from the first test on');
        }
        return this.collection_;
    }

    /** Who came last. */
    get visitor(): Visitor {
        if (!this.visitor_) {
            throw new Error('nobody has come yet');
        }
        return this.visitor_;
    }

    /** A visitor whose page is still empty. */
    async come(options: BrowserContextOptions = {}): Promise<Page> {
        const { browser, origin } = this.collection;
        this.visitor_ = await visit(browser, origin, options);
        return this.visitor_.page;
    }

    /** A visitor at an address of the gallery, `#/…`. */
    async open(hash: string, options: BrowserContextOptions = {}): Promise<Page> {
        const page = await this.come(options);
        await page.goto(`${this.collection.origin}/${hash}`);
        return page;
    }
}
