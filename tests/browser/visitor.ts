import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';

/** Software WebGL on a busy machine is slow; what hangs, hangs longer than this. */
export const kPatienceMs = Number(process.env.OSSUARY_BROWSER_PATIENCE_MS ?? 240_000);
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
