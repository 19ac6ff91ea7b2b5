// Takes a picture of a page of the gallery with Debian's Chromium, software WebGL included.
import { chromium } from 'playwright-core';

const kUsage = `Usage: npm run screenshot -- URL OUT.png [--dark] [--width N] [--height N] [--scale N] [--full]

The page counts as ready when nothing is being loaded, no skeleton card is left and every 3D picture is
drawn.
Example: npm run screenshot -- 'http://127.0.0.1:8080/#/models/1/hits/2' viewer.png --dark`;

function parse(words) {
    const options = { width: 1440, height: 900, scale: 1, dark: false, full: false };
    const places = [];
    for (let at = 0; at < words.length; at++) {
        const word = words[at];
        if (word === '--dark' || word === '--full') {
            options[word.slice(2)] = true;
        } else if (word === '--width' || word === '--height' || word === '--scale') {
            at += 1;
            options[word.slice(2)] = Number(words[at]);
        } else {
            places.push(word);
        }
    }
    const [url, out] = places;
    const numbers = [options.width, options.height, options.scale];
    return url && out && places.length === 2 && numbers.every((number) => number > 0)
        ? { ...options, url, out }
        : null;
}

const options = parse(process.argv.slice(2));
if (!options) {
    console.error(kUsage);
    process.exit(2);
}
const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
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
try {
    const page = await browser.newPage({
        viewport: { width: options.width, height: options.height },
        deviceScaleFactor: options.scale,
        colorScheme: options.dark ? 'dark' : 'light',
        reducedMotion: 'reduce',
    });
    await page.goto(options.url, { waitUntil: 'networkidle' });
    await page.waitForFunction(
        () =>
            !document.querySelector(
                '[aria-busy], .card-loading, .curve-loading, .working, [data-picture=pending]',
            ),
        undefined,
        { timeout: 120_000 },
    );
    // Lazy pictures are asked for only when they are near.
    await page.waitForFunction(() =>
        [...document.querySelectorAll('.thumbnail')].every(
            (picture) =>
                picture.matches('.thumbnail-ready, .thumbnail-missing') ||
                picture.getBoundingClientRect().top > innerHeight,
        ),
    );
    await page.screenshot({ path: options.out, fullPage: options.full });
} finally {
    await browser.close();
}
