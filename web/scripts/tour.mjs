// Walks the three ways of docs/tour.md with Debian's Chromium and takes their pictures: the programs index
// and serve figures of our own (sample_models.mjs), and each way has to end with what was wanted.
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

import { writeSampleModels } from './sample_models.mjs';

const fromRoot = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const kOut = fromRoot('docs/tour');
const kBin = process.env.OSSUARY_BIN_FOLDER ?? fromRoot('build/release/bin');
const kKey = 'a-key-for-the-tour-0123456789';
const kPatienceMs = Number(process.env.OSSUARY_BROWSER_PATIENCE_MS ?? 240_000);

function check(holds, what) {
    if (!holds) {
        throw new Error(`the tour does not end well: ${what}`);
    }
}

function startServer(index) {
    const server = spawn(
        join(kBin, 'ossuary-server'),
        [
            '--index',
            index,
            '--web',
            fromRoot('web/dist'),
            '--port',
            '0',
            '--serve-files',
            '--log-level',
            'warn',
        ],
        {
            stdio: ['ignore', 'pipe', 'inherit'],
            env: { ...process.env, OSSUARY_ADMIN_KEY: kKey },
        },
    );
    return new Promise((resolve, reject) => {
        let said = '';
        server.stdout.setEncoding('utf8');
        server.stdout.on('data', (text) => {
            said += text;
            const origin = /listening on (http:\/\/\S+)/.exec(said)?.[1];
            if (origin) {
                resolve({ server, origin });
            }
        });
        server.on('exit', () => reject(new Error(`the server ended: ${said}`)));
    });
}

/** Until every 3D picture and every picture of a card in sight is there. */
async function drawn(page) {
    await page.waitForFunction(
        () =>
            !document.querySelector(
                '[aria-busy], .card-loading, .curve-loading, .working, [data-picture=pending]',
            ) &&
            [...document.querySelectorAll('.thumbnail')].every(
                (picture) =>
                    picture.matches('.thumbnail-ready, .thumbnail-missing') ||
                    picture.getBoundingClientRect().top > innerHeight,
            ),
    );
    // Pictures of cards fade in.
    await page.waitForTimeout(400);
}

async function take(page, name) {
    await drawn(page);
    await page.screenshot({ path: join(kOut, `${name}.png`) });
    console.log(`docs/tour/${name}.png`);
}

/** A maker has a file and wants those that are nearly the same, to print one of them. */
async function maker(page, origin, models) {
    await page.goto(`${origin}/#/`);
    const file = join(models, 'animals', 'horse-3.off');
    await page.locator('.header input[type=file]').setInputFiles({
        name: 'my horse.off',
        mimeType: 'model/off',
        buffer: readFileSync(file),
    });
    await page.locator('.hit-card').first().waitFor();
    check((await page.locator('.hit-card .tag').first().textContent()) === 'horse', 'no horse');
    await take(page, 'maker-1-hits');
    await page.locator('.hit-card .card-link').nth(1).click();
    await page.locator('.match-table').waitFor();
    await page.getByLabel('Overlay', { exact: true }).check();
    await page.locator('.overlay canvas').waitFor();
    await take(page, 'maker-2-overlay');
    await page.locator('dialog .take-away summary').click();
    const download = page.waitForEvent('download');
    await page.locator('dialog .take-away-list a', { hasText: 'STL' }).click();
    check((await (await download).suggestedFilename()).endsWith('.stl'), 'no STL');
}

/** An animator wants a figure with joints, in a pose of its own, and others that stand like it. */
async function animator(page, origin) {
    await page.goto(`${origin}/#/?class=people`);
    await page.locator('.card-link').first().click();
    await page.locator('.query-text').getByText('Parts and pose').click();
    await page.locator('.joint-handle').first().waitFor();
    await drawn(page);
    const joints = await page.locator('.joint-handle').count();
    for (let joint = 0; joint < joints; joint++) {
        await page.locator('.joint-handle').nth(joint).focus();
        for (let press = 0; press < 4; press++) {
            await page.keyboard.press(joint % 2 === 0 ? 'ArrowRight' : 'ArrowUp');
        }
    }
    check(page.url().includes('posed='), 'no pose in the address');
    await take(page, 'animator-1-pose');
    await page.keyboard.press('Escape');
    await page.locator('dialog').waitFor({ state: 'detached' });
    await page.locator('.like-link', { hasText: 'Same pose' }).first().click();
    await page.locator('.hit-card').first().waitFor();
    check(page.url().includes('pose=1'), 'not by pose');
    await take(page, 'animator-2-same-pose');
}

/** A researcher wants to know how far the rankings can be trusted, and where they fail. */
async function researcher(page, origin) {
    await page.goto(`${origin}/#/reports`);
    await page.locator('.metrics-table tbody tr').nth(2).waitFor();
    await take(page, 'researcher-1-reports');
    await page.getByText('Query by query').click();
    const row = page.locator('.query-comparison tbody tr').first();
    await row.waitFor();
    await row.scrollIntoViewIfNeeded();
    await take(page, 'researcher-2-queries');
    const download = page.waitForEvent('download');
    await page.getByText(/Save all \d+ as CSV/).click();
    check((await (await download).suggestedFilename()) === 'queries.csv', 'no table');
    await row.locator('a').last().click();
    await page.locator('.hit-card').first().waitFor();
    await page.locator('.query-text').getByText('Look closer').click();
    await page.locator('.branch-table').waitFor();
    await take(page, 'researcher-3-look');
}

mkdirSync(kOut, { recursive: true });
const folder = mkdtempSync(join(tmpdir(), 'ossuary-tour-'));
let server = null;
let browser = null;
try {
    const models = join(folder, 'models');
    const classes = join(folder, 'classes.cla');
    writeSampleModels(models, classes);
    const index = join(folder, 'tour.ossuary');
    const built = spawnSync(
        join(kBin, 'ossuary'),
        ['index', '--index', index, '--classes', classes, models],
        { stdio: ['ignore', 'ignore', 'inherit'] },
    );
    check(built.status === 0, 'the figures cannot be indexed');
    const started = await startServer(index);
    server = started.server;
    browser = await chromium.launch({
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        args: [
            '--no-sandbox',
            '--use-angle=swiftshader',
            '--enable-unsafe-swiftshader',
            '--disable-background-networking',
        ],
    });
    for (const way of [maker, animator, researcher]) {
        const context = await browser.newContext({
            viewport: { width: 1200, height: 760 },
            reducedMotion: 'reduce',
        });
        context.setDefaultTimeout(kPatienceMs);
        await way(await context.newPage(), started.origin, models);
        await context.close();
    }
} finally {
    await browser?.close();
    server?.kill();
    rmSync(folder, { recursive: true, force: true });
}
