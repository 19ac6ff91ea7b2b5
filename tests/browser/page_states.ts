import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import type { Page } from 'playwright-core';

import { answerWithLongWords, answerWithProblem } from './long_words';
import { kClasses, kModelsPerClass, type WrittenModels } from './models';
import { untilDrawn } from './pictures';
import { kAdminKey } from './server';

const kModels = kClasses.length * kModelsPerClass;

/** A state that a page can be in. */
export interface State {
    hash: string;
    /** Before the page is opened. */
    prepare?: (page: Page) => Promise<unknown>;
    /** Until the state is there. */
    reach: (page: Page) => Promise<void>;
}

/** Waits until that is there. */
export const seen =
    (selector: string) =>
    (page: Page): Promise<void> =>
        page.locator(selector).first().waitFor();

async function upload(page: Page, file: string, name = basename(file)): Promise<void> {
    const buffer = readFileSync(file);
    await page
        .locator('.header input[type=file]')
        .setInputFiles({ name, mimeType: 'text/plain', buffer });
}

async function openOptions(page: Page): Promise<void> {
    // Where there is room they are open.
    const options = page.locator('details.options:not(.more-filters)');
    if ((await options.getAttribute('open')) === null) {
        await options.locator('> summary').click();
    }
    await page.locator('.search-form').waitFor();
}

const speakGerman = (page: Page): Promise<unknown> =>
    page.addInitScript(() => localStorage.setItem('ossuary.language', 'de'));

/** Where something is confused. */
async function openConfusion(page: Page): Promise<void> {
    const cell = page.locator('.cell-button').first();
    if ((await cell.count()) > 0) {
        await cell.click();
        await page.locator('.confused ul, .confused p:not(.working)').first().waitFor();
    }
}

/** Never answers: what is shown meanwhile stays. */
const silent = (path: string) => async (page: Page) => {
    await page.route(path, () => {});
};

/** All of them, by name. */
export function pageStates(models: WrittenModels): Readonly<Record<string, State>> {
    return {
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
        'the start page with filters by numbers': {
            hash: '#/?branches=1-4',
            reach: (page) =>
                page
                    .locator('.more-filters select[name=branches] option')
                    .nth(1)
                    .waitFor({ state: 'attached' }),
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
                await upload(page, models.truncated);
                await seen('.notice-problem')(page);
            },
        },
        'several uploads, one of them refused': {
            hash: '#/reports',
            reach: async (page) => {
                const buffer = readFileSync(models.query);
                const cut = readFileSync(models.truncated);
                const file = (name: string, bytes: Buffer) => ({
                    name,
                    mimeType: 'text/plain',
                    buffer: bytes,
                });
                await page
                    .locator('.header input[type=file]')
                    .setInputFiles([
                        file('a.off', buffer),
                        file('b.off', cut),
                        file('c.off', buffer),
                    ]);
                await page.locator('.chip a').nth(1).waitFor();
                await seen('.notice-problem')(page);
                await seen('.query-text a')(page);
            },
        },
        'an upload under way': {
            hash: '#/',
            prepare: silent('**/v1/search*'),
            reach: async (page) => {
                await upload(page, models.query);
                await seen('.progress')(page);
            },
        },
        'an upload under way, with its stage': {
            hash: '#/',
            prepare: async (page) => {
                await page.addInitScript(() => {
                    // All of it is on its way, and no answer comes.
                    XMLHttpRequest.prototype.send = function (this: XMLHttpRequest) {
                        setTimeout(() => this.upload.dispatchEvent(new ProgressEvent('load')), 0);
                    };
                });
                await page.route('**/v1/progress/*', (route) =>
                    route.fulfill({ json: { stage: 'describe_skeleton' } }),
                );
            },
            reach: async (page) => {
                await upload(page, models.query, `${'W'.repeat(60)}.off`);
                await page.locator('.progress-line', { hasText: 'step 7 of 12' }).waitFor();
            },
        },
        'hits of an upload with a long name': {
            hash: '#/',
            reach: async (page) => {
                await upload(page, models.query, `${'W'.repeat(60)}.off`);
                await seen('.hit-card')(page);
                await seen('.query-text a')(page);
            },
        },
        'what can be taken away of an upload': {
            hash: '#/',
            reach: async (page) => {
                await upload(page, models.query);
                await page.locator('.query .take-away summary').click();
                await seen('.take-away-list')(page);
            },
        },
        'hits of a model': { hash: `#/models/${kModels}`, reach: seen('.hit-card') },
        'hits by their names': {
            hash: `#/models/${kModels}?sort=name`,
            reach: seen('.hit-order:not([hidden])'),
        },
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
        'an upload that the server has forgotten': {
            hash: `#/q/${'0'.repeat(32)}`,
            reach: seen('.notice-empty'),
        },
        'the comparison': {
            hash: `#/models/${kModels}/hits/1`,
            reach: async (page) => {
                await seen('.match-table')(page);
                await untilDrawn(page.locator('dialog .pane-canvas').last());
            },
        },
        'the comparison, and what can be taken away': {
            hash: `#/models/${kModels}/hits/1`,
            reach: async (page) => {
                await seen('.match-table')(page);
                await page.locator('dialog .take-away summary').click();
                await seen('dialog .take-away-list')(page);
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
        'the comparison, one laid over the other': {
            hash: `#/models/${kModels}/hits/1`,
            reach: async (page) => {
                await seen('.match-table')(page);
                await page.getByLabel('Overlay', { exact: true }).check();
                await untilDrawn(page.locator('.overlay canvas'));
            },
        },
        'a closer look with all that can be set': {
            hash: `#/models/${kModels}/look`,
            reach: async (page) => {
                await untilDrawn(page.locator('dialog .pane-canvas'));
                await page.locator('.look-more summary').click();
                await page.getByLabel('Measure', { exact: true }).check();
                await page.locator('.look-panel input').last().waitFor();
            },
        },
        'a closer look at long names': {
            hash: `#/models/${kModels}/look`,
            prepare: answerWithLongWords,
            reach: seen('.branch-table tbody tr'),
        },
        'a model within another page': {
            hash: 'embed.html#/models/1',
            reach: (page) => untilDrawn(page.locator('.pane-canvas')),
        },
        'the start page with models selected': {
            hash: '#/',
            reach: async (page) => {
                await page.locator('.card-check input').first().check();
                await page.locator('.card-check input').nth(1).check();
                await seen('.selection-bar a')(page);
            },
        },
        'the start page in German': {
            hash: '#/',
            prepare: speakGerman,
            reach: seen('.collection .card-link'),
        },
        'hits in German': {
            hash: `#/models/${kModels}`,
            prepare: speakGerman,
            reach: async (page) => {
                await seen('.hit-card')(page);
                await openOptions(page);
            },
        },
        'the way to what needs the key': { hash: '#/manage', reach: seen('input[name=key]') },
        'the collection in the hands of who has the key': {
            hash: '#/manage',
            prepare: (page) =>
                page.addInitScript((key) => {
                    sessionStorage.setItem('ossuary.admin-key', key);
                    const chosen = { id: 1, name: '1', path: '1.off', class: null };
                    sessionStorage.setItem('ossuary.selection', JSON.stringify([chosen]));
                }, kAdminKey),
            reach: async (page) => {
                await seen('.failures')(page);
                await seen('.jobs .fine')(page);
            },
        },
        'what was added, in the hands of who has the key': {
            hash: '#/manage',
            prepare: async (page) => {
                await page.addInitScript((key) => {
                    sessionStorage.setItem('ossuary.admin-key', key);
                }, kAdminKey);
                const error = { code: 'mesh_empty', message: `${'W'.repeat(60)} has no triangle` };
                const job = {
                    name: 'W'.repeat(60),
                    class: 'W'.repeat(30),
                    size: 1_234_567,
                    accepted_at: '2026-05-01T12:00:00Z',
                    finished_at: null,
                };
                const jobs = [
                    { ...job, id: 4, state: 'queued', model: null, error: null },
                    { ...job, id: 3, state: 'running', model: null, error: null },
                    { ...job, id: 2, state: 'failed', model: null, error },
                    { ...job, id: 1, state: 'done', model: 1, error: null },
                ];
                await page.route('**/v1/jobs?*', (route) => route.fulfill({ json: { jobs } }));
            },
            reach: seen('.jobs tbody tr:nth-child(4)'),
        },
        'the reports, query by query': {
            hash: '#/reports',
            reach: async (page) => {
                await page.getByText('Query by query').click();
                await seen('.query-comparison tbody tr')(page);
                await openConfusion(page);
            },
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
            prepare: (page) =>
                answerWithProblem(page, '**/v1/evaluations/**', 'evaluation_not_found'),
            reach: seen('.notice-empty'),
        },
        'reports that fail': {
            hash: '#/reports',
            prepare: (page) => answerWithProblem(page, '**/v1/evaluations/**', 'overloaded'),
            reach: seen('.notice-problem'),
        },
        'a page that is not there': { hash: '#/nowhere', reach: seen('.notice') },
    };
}

const kNoModels: WrittenModels = {
    folder: '',
    classes: '',
    query: '',
    truncated: '',
    painted: '',
};

export const kStateNames = Object.keys(pageStates(kNoModels));
