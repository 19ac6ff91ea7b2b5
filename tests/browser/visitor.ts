import {
    type Browser,
    type BrowserContextOptions,
    chromium,
    type Locator,
    type Page,
} from 'playwright-core';

/** Software WebGL on a busy machine is slow; what hangs, hangs longer than this. */
const kPatienceMs = 90_000;
const kChromium = process.env.CHROMIUM ?? '/usr/bin/chromium';

/** Headless, WebGL in software, and silent towards the network. */
export function launchBrowser(): Promise<Browser> {
    return chromium.launch({
        executablePath: kChromium,
        args: [
            '--no-sandbox',
            '--use-angle=swiftshader',
            '--enable-unsafe-swiftshader',
            '--disable-background-networking',
            '--disable-component-update',
            '--disable-sync',
            '--no-first-run',
        ],
    });
}

export interface Visitor {
    page: Page;
    /** What the page complained of: console errors, exceptions, policy violations. */
    complaints: string[];
    /** Addresses of requests to anywhere but the server. */
    strangers: string[];
    close(): Promise<void>;
}

/** A page with a clean profile that writes down whatever it should not do. */
export async function visit(
    browser: Browser,
    origin: string,
    options: BrowserContextOptions = {},
): Promise<Visitor> {
    const context = await browser.newContext({
        viewport: { width: 1280, height: 860 },
        reducedMotion: 'reduce',
        ...options,
    });
    context.setDefaultTimeout(kPatienceMs);
    const page = await context.newPage();
    const complaints: string[] = [];
    const strangers: string[] = [];
    page.on('console', (message) => {
        if (message.type() === 'error') {
            complaints.push(message.text());
        }
    });
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('request', (request) => {
        if (new URL(request.url()).origin !== origin) {
            strangers.push(request.url());
        }
    });
    return { page, complaints, strangers, close: () => context.close() };
}

/** How many colours a picture of the element has, and how much of it is not the most common one. */
export async function looksOf(target: Locator): Promise<{ colors: number; drawn: number }> {
    const png = (await target.screenshot()).toString('base64');
    return target.page().evaluate(async (encoded) => {
        const bytes = Uint8Array.from(atob(encoded), (character) => character.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const drawing = canvas.getContext('2d');
        drawing?.drawImage(bitmap, 0, 0);
        const pixels = drawing?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? [];
        const counts = new Map<number, number>();
        for (let at = 0; at + 2 < pixels.length; at += 4) {
            // The ground is a gentle gradient: only its coarse colour counts.
            const color =
                (((pixels[at] ?? 0) >> 5) << 10) |
                (((pixels[at + 1] ?? 0) >> 5) << 5) |
                ((pixels[at + 2] ?? 0) >> 5);
            counts.set(color, (counts.get(color) ?? 0) + 1);
        }
        const most = Math.max(...counts.values());
        return { colors: counts.size, drawn: 1 - most / (bitmap.width * bitmap.height) };
    }, png);
}

/** A picture of the element once two in a row are the same: everything under way has been drawn. */
export async function settledPicture(target: Locator): Promise<Buffer> {
    let last = await target.screenshot();
    let still = 0;
    for (let attempt = 0; attempt < 40; attempt++) {
        await target.page().waitForTimeout(150);
        const next = await target.screenshot();
        // Twice: on a busy machine one frame may take longer than the wait.
        still = next.equals(last) ? still + 1 : 0;
        if (still === 2) {
            return next;
        }
        last = next;
    }
    throw new Error('the picture does not come to rest');
}
