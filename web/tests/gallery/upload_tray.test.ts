import { afterEach, beforeEach, expect, it } from 'vitest';

import { ApiError } from '../../src/api/problem';
import { kSearchDefaults } from '../../src/api/search_parameters';
import { type UploadTray, uploadTray } from '../../src/gallery/upload_tray';
import { contextWith, searchResult, settled } from '../sample';

let tray: UploadTray | null = null;

beforeEach(() => sessionStorage.clear());

afterEach(() => {
    tray?.dispose();
    tray = null;
});

const kBad = new ApiError({ title: 'No', status: 422, detail: 'line 3', code: 'off_truncated' });
let tokens = 0;

function opened() {
    const context = contextWith({
        search: async ({ name }) => {
            if (name === 'bad.off') {
                throw kBad;
            }
            tokens += 1;
            return { ...searchResult(), token: tokens.toString(16).padStart(32, '0') };
        },
    });
    tray = uploadTray(context);
    const take = (...names: string[]) =>
        context.uploads.take(
            names.map((name) => new File(['OFF'], name)),
            kSearchDefaults,
        );
    return { node: tray.node, take, context };
}

it('shows what runs, and nothing once a single one is done', async () => {
    const { node, take } = opened();
    expect(node.hidden).toBe(true);
    take('a.off');
    expect(node.hidden).toBe(false);
    expect(node.querySelector('[role=progressbar]')?.getAttribute('aria-label')).toContain('a.off');
    await settled();
    expect(node.hidden).toBe(true);
});

it('leads to each of several', async () => {
    const { node, take } = opened();
    take('a.off', 'b.off');
    await settled();
    const links = [...node.querySelectorAll('.chip a')];
    expect(links.map((link) => link.textContent)).toEqual(['a.off', 'b.off']);
    for (const link of links) {
        expect(link.getAttribute('href')).toMatch(/^#\/q\/[0-9a-f]{32}$/);
    }
    node.querySelector<HTMLButtonElement>('[aria-label="Forget a.off"]')?.click();
    expect(node.querySelectorAll('.chip')).toHaveLength(0);
});

it('says what is wrong with a file until that is read', async () => {
    const { node, take } = opened();
    take('bad.off', 'good.off');
    await settled();
    expect(node.querySelector('.notice-code')?.textContent).toBe('off_truncated');
    node.querySelector<HTMLButtonElement>('[aria-label="Close: bad.off"]')?.click();
    expect(node.querySelector('.notice')).toBeNull();
    expect(node.hidden).toBe(true);
});

it('says what is wrong with what was dropped', () => {
    const { node } = opened();
    tray?.complain(kBad);
    expect(node.hidden).toBe(false);
    node.querySelector<HTMLButtonElement>('.chip-close')?.click();
    expect(node.hidden).toBe(true);
});
