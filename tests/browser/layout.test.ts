import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';

import { type ServedCollection, serveCollection } from './collection';
import { layoutFaults } from './layout_faults';
import { answerWithLongWords, answerWithProblem } from './long_words';
import { kClasses, kModelsPerClass } from './models';
import { untilDrawn, type Visitor, visit } from './visitor';

const kModels = kClasses.length * kModelsPerClass;
const kNarrow = { width: 320, height: 700 };

let collection: ServedCollection;
let visitor: Visitor;

beforeAll(async () => {
    collection = await serveCollection();
});

afterAll(async () => {
    await collection?.stop();
});

afterEach(async () => {
    await visitor?.close();
});

interface State {
    hash: string;
    /** Before the page is opened. */
    prepare?: (page: Page) => Promise<unknown>;
    /** Until the state is there. */
    reach: (page: Page) => Promise<void>;
}

const seen =
    (selector: string) =>
    (page: Page): Promise<void> =>
        page.locator(selector).first().waitFor();

async function upload(page: Page, file: string): Promise<void> {
    await page.locator('#model-file').setInputFiles(file);
}

async function openOptions(page: Page): Promise<void> {
    await page.locator('details.options > summary').click();
    await page.locator('.search-form').waitFor();
}

/** Never answers: what is shown meanwhile stays. */
const silent = (path: string) => async (page: Page) => {
    await page.route(path, () => {});
};

const kStates: Readonly<Record<string, State>> = {
    'the start page': { hash: '#/', reach: seen('.collection .card-link') },
    'the start page, long names': {
        hash: '#/',
        prepare: answerWithLongWords,
        reach: seen('.collection .tag'),
    },
    'the start page with its options': {
        hash: '#/',
        reach: async (page) => {
            await seen('.collection .card-link')(page);
            await openOptions(page);
        },
    },
    'the start page while it loads': {
        hash: '#/',
        prepare: silent('**/v1/models*'),
        reach: seen('.card-loading'),
    },
    'the start page without a model that fits': {
        hash: '#/?name=nothing',
        reach: seen('.notice-empty'),
    },
    'the start page of a server in trouble': {
        hash: '#/',
        prepare: (page) => answerWithProblem(page, '**/v1/models*', 'index_busy_'.repeat(5)),
        reach: seen('.notice-problem'),
    },
    'an upload that is refused': {
        hash: '#/',
        reach: async (page) => {
            await upload(page, collection.models.truncated);
            await seen('.notice-problem')(page);
        },
    },
    'an upload under way': {
        hash: '#/',
        prepare: silent('**/v1/search*'),
        reach: async (page) => {
            await upload(page, collection.models.query);
            await seen('.progress')(page);
        },
    },
    'hits of an upload': {
        hash: '#/',
        prepare: answerWithLongWords,
        reach: async (page) => {
            await upload(page, collection.models.query);
            await seen('.hit-card')(page);
            await seen('.facts')(page);
        },
    },
    'hits of a model': { hash: `#/models/${kModels}`, reach: seen('.hit-card') },
    'hits of a model with long names, options open': {
        hash: `#/models/${kModels}`,
        prepare: answerWithLongWords,
        reach: async (page) => {
            await seen('.hit-card .tag')(page);
            await openOptions(page);
            await page.locator('.warnings summary').click();
        },
    },
    'no hits': { hash: `#/models/${kModels}?class=nothing`, reach: seen('.notice-empty') },
    'a search that fails': {
        hash: `#/models/${kModels}`,
        prepare: (page) => answerWithProblem(page, '**/similar*', 'search_timeout'),
        reach: seen('.notice-problem'),
    },
    'an upload that is gone': { hash: '#/search', reach: seen('.notice-empty') },
    'the comparison': {
        hash: `#/models/${kModels}/hits/1`,
        reach: async (page) => {
            await seen('.match-table')(page);
            await untilDrawn(page.locator('dialog .pane-canvas').last());
        },
    },
    'the comparison of long names': {
        hash: `#/models/${kModels}/hits/1`,
        prepare: answerWithLongWords,
        reach: seen('.match-table'),
    },
    'the comparison while it loads': {
        hash: `#/models/${kModels}/hits/1`,
        prepare: silent('**/v1/models/1/mesh'),
        reach: seen('.dialog-loading'),
    },
    'the comparison without WebGL': {
        hash: `#/models/${kModels}/hits/1`,
        prepare: (page) =>
            page.addInitScript(() => {
                HTMLCanvasElement.prototype.getContext = () => null;
            }),
        reach: seen('dialog .no-webgl'),
    },
    'the parts': {
        hash: `#/models/${kModels}/parts`,
        reach: async (page) => {
            await seen('.part-legend')(page);
            await untilDrawn(page.locator('dialog .pane-canvas'));
        },
    },
    'the parts of a long name': {
        hash: `#/models/${kModels}/parts`,
        prepare: answerWithLongWords,
        reach: seen('.part-legend'),
    },
    'parts that the server cannot give': {
        hash: `#/models/${kModels}/parts`,
        prepare: (page) => answerWithProblem(page, '**/rig.glb', 'segments_not_available'),
        reach: seen('dialog .notice-problem'),
    },
    'the reports': { hash: '#/reports', reach: seen('.metrics-table tbody tr:nth-child(3)') },
    'the reports of long classes': {
        hash: '#/reports',
        prepare: answerWithLongWords,
        reach: seen('.metrics-table tbody tr:nth-child(3)'),
    },
    'the reports while they are computed': {
        hash: '#/reports',
        prepare: silent('**/v1/evaluations/**'),
        reach: seen('.working'),
    },
    'no reports': {
        hash: '#/reports',
        prepare: (page) => answerWithProblem(page, '**/v1/evaluations/**', 'evaluation_not_found'),
        reach: seen('.notice-empty'),
    },
    'reports that fail': {
        hash: '#/reports',
        prepare: (page) => answerWithProblem(page, '**/v1/evaluations/**', 'overloaded'),
        reach: seen('.notice-problem'),
    },
    'a page that is not there': { hash: '#/nowhere', reach: seen('.notice') },
};

async function reach({ hash, prepare, reach: arrive }: State): Promise<Page> {
    visitor = await visit(collection.browser, collection.origin, { viewport: kNarrow });
    const { page } = visitor;
    await prepare?.(page);
    await page.goto(`${collection.origin}/${hash}`);
    await arrive(page);
    return page;
}

it('would notice a grid that insists on the width of its contents', async () => {
    const page = await reach({ hash: '#/', reach: seen('.collection .card-link') });
    await page.evaluate(() => {
        for (const card of document.querySelectorAll<HTMLElement>('.card')) {
            card.style.minWidth = 'max-content';
        }
    });
    expect((await layoutFaults(page)).length).toBeGreaterThan(0);
});

describe(`at ${kNarrow.width} px, whatever the width of letters`, () => {
    it.each(Object.keys(kStates))('%s fits', async (name) => {
        const page = await reach(kStates[name] as State);
        expect(await layoutFaults(page)).toEqual([]);
    });
});
