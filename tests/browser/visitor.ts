import {
    type Browser,
    type BrowserContextOptions,
    chromium,
    type Locator,
    type Page,
} from 'playwright-core';

/** Software WebGL on a busy machine is slow; what hangs, hangs longer than this. */
const kPatienceMs = 240_000;
const kChromium = process.env.CHROMIUM ?? '/usr/bin/chromium';

/** Headless, WebGL in software, and silent towards the network. */
export function launchBrowser(): Promise<Browser> {
    return chromium.launch({
        executablePath: kChromium,
        timeout: kPatienceMs,
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

/** Waits until a 3D picture shows what was asked for last. */
export async function untilDrawn(canvas: Locator): Promise<void> {
    await canvas.evaluate(async () => {
        // What the mouse did is handled with the next frame.
        for (let frame = 0; frame < 2; frame++) {
            await new Promise(requestAnimationFrame);
        }
    });
    await canvas
        .and(canvas.page().locator('[data-picture=drawn]'))
        .waitFor({ state: 'attached', timeout: kPatienceMs });
}

/** What a 3D picture looks like once it is drawn. */
export async function pictureOf(canvas: Locator): Promise<Buffer> {
    await untilDrawn(canvas);
    return canvas.screenshot();
}

export interface Looks {
    colors: number;
    /** Share of the picture, 0 to 1. */
    drawn: number;
}

/** How many colours a picture has, and how much of it is not the most common one. */
export async function looksOf(picture: Buffer, page: Page): Promise<Looks> {
    const png = picture.toString('base64');
    return page.evaluate(async (encoded) => {
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
