// Measures how quick the gallery is in Debian's Chromium: first paint by the clock; by processor time of the page's
// thread the longest task between a hand and the next paint, also with a hundred thousand models (the server's
// first one over and over) while they are scrolled and searched by name.
import { chromium } from 'playwright-core';

const kUsage =
    'Usage: npm run figures -- URL     of a server with a gallery and a collection with classes';
const kTotal = 100_000;
const kRuns = 5;

const origin = process.argv[2]?.replace(/\/$/, '');
if (!origin) {
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
    ],
});

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const say = (what, ms, most) =>
    console.log(`| ${what} | ${ms.toFixed(0)} ms | ${most === null ? '' : `≤ ${most} ms`} |`);

async function open(hash, prepare = async () => {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 860 } });
    context.setDefaultTimeout(240_000);
    const page = await context.newPage();
    await prepare(page);
    await page.goto(`${origin}/${hash}`);
    return page;
}

async function firstPaint(hash, prepare) {
    const times = [];
    for (let run = 0; run < kRuns; run++) {
        const page = await open(hash, prepare);
        await page.locator('.card-link').first().waitFor();
        const painted = await page.waitForFunction(
            () => performance.getEntriesByType('paint').at(-1)?.startTime,
        );
        times.push(await painted.jsonValue());
        await page.context().close();
    }
    return median(times);
}

/**
 * The longest stretch of processor time that the page's thread spends at once while `act` runs, so that a busy
 * machine tells the same as an idle one.
 */
async function longestTask(page, act) {
    const session = await page.context().newCDPSession(page);
    const events = [];
    session.on('Tracing.dataCollected', ({ value }) => events.push(...value));
    const ended = new Promise((resolve) => session.once('Tracing.tracingComplete', resolve));
    await session.send('Tracing.start', {
        transferMode: 'ReportEvents',
        traceConfig: { includedCategories: ['toplevel', 'disabled-by-default-devtools.timeline'] },
    });
    await act();
    await page.waitForTimeout(800);
    await session.send('Tracing.end');
    await ended;
    await session.detach();
    const main = new Set(
        events
            .filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain')
            .map(({ pid, tid }) => `${pid} ${tid}`),
    );
    const tasks = events.filter(
        ({ name, pid, tid, tdur }) =>
            /RunTask$/.test(name) && tdur !== undefined && main.has(`${pid} ${tid}`),
    );
    return Math.max(0, ...tasks.map(({ tdur }) => tdur / 1000));
}

/** Of several runs, the middle one. */
async function nextPaint(page, act) {
    const times = [];
    for (let run = 0; run < 3; run++) {
        times.push(await longestTask(page, () => act(run)));
    }
    return median(times);
}

async function pretend(page) {
    const response = await page.request.get(`${origin}/v1/models?limit=1`);
    const [model] = (await response.json()).models;
    await page.route('**/v1/models?*', (route) => {
        const { searchParams } = new URL(route.request().url());
        const number = (name) => Number(searchParams.get(name));
        const total = searchParams.has('name') ? 111 : kTotal;
        const count = Math.max(0, Math.min(number('limit'), total - number('offset')));
        const models = Array.from({ length: count }, (_, at) => {
            const id = number('offset') + at + 1;
            return { ...model, id, name: `${searchParams.get('name') ?? 'model'} ${id}` };
        });
        return route.fulfill({ json: { models, next_cursor: null, total, revision: 1 } });
    });
}

/** While the wheel turns. */
async function scroll(page) {
    await page.mouse.move(640, 600);
    for (let turn = 0; turn < 40; turn++) {
        await page.mouse.wheel(0, 400);
        await page.waitForTimeout(30);
    }
}

/** What the page itself takes for a letter, once the server has answered. */
function nameSearch(page) {
    const field = page.locator('.filters [name=name]');
    return nextPaint(page, (run) => field.press('chair'[run]));
}

try {
    console.log('| what | measured | wanted |\n|---|---|---|');
    say('first paint of the start page', await firstPaint('#/'), 300);
    const home = await open('#/');
    await home.locator('.card-check input').first().waitFor();
    say(
        'a model is ticked',
        await nextPaint(home, () =>
            home.locator('.card-check input').first().click({ force: true }),
        ),
        100,
    );
    say(
        'a letter is typed',
        await nextPaint(home, () => home.locator('.filters [name=name]').press('a')),
        100,
    );
    await home.context().close();
    const hits = await open('#/models/1');
    await hits.locator('.hit-card').first().waitFor();
    await hits.locator('.query-picture canvas').waitFor();
    await hits.waitForTimeout(1000);
    say(
        'another ranker',
        await nextPaint(hits, (run) =>
            hits
                .locator('.segmented label')
                .nth(1 + (run % 2))
                .click(),
        ),
        100,
    );
    await hits.locator('.hit-card a').first().click();
    await hits.locator('.match-table').waitFor();
    await hits.waitForTimeout(2000);
    say(
        'nodes are shown or not',
        await nextPaint(hits, () => hits.getByLabel('Nodes', { exact: true }).click()),
        100,
    );
    say(
        'one laid over the other',
        // Off and on again: it is there before the clock stops.
        await nextPaint(hits, async () => {
            const overlay = hits.getByLabel('Overlay', { exact: true });
            await overlay.uncheck();
            await overlay.check();
            await hits.locator('.overlay canvas').waitFor();
        }),
        100,
    );
    await hits.context().close();

    say('100,000 models: first paint', await firstPaint('#/', pretend), 1000);
    const many = await open('#/', pretend);
    await many.locator('.card-link').first().waitFor();
    say(
        '100,000 models: the longest task while scrolling',
        await longestTask(many, () => scroll(many)),
        50,
    );
    say('100,000 models: a letter in the name, without the server', await nameSearch(many), 150);
    await many.context().close();
} finally {
    await browser.close();
}
