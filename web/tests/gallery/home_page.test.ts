import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import { homePage } from '../../src/gallery/home_page';
import type { Page } from '../../src/page/context';
import { kHome } from '../../src/page/routes';
import { contextWith, searchResult, settled } from '../sample';

const models = async () => ({ models: [], next_cursor: null, total: 0, revision: 1 });

let page: Page | null = null;

beforeEach(() => sessionStorage.clear());

afterEach(() => {
    page?.dispose();
    page?.node.remove();
    page = null;
});

it('searches with the chosen file as its options say', async () => {
    const search = vi.fn(async () => searchResult());
    const context = contextWith({ models, search });
    page = homePage(kHome, context);
    document.body.append(page.node);
    const { node } = page;
    const rerank = () => node.querySelector<HTMLInputElement>('[name=rerank]');
    expect(rerank(), 'nobody has opened the options').toBeNull();
    const options = node.querySelector<HTMLDetailsElement>('.hero details');
    if (options) {
        options.open = true;
    }
    await vi.waitFor(() => expect(rerank()).not.toBeNull());
    rerank()?.click();
    expect(context.parameters.rerank).toBe(true);
    const input = page.node.querySelector('input[type=file]') as HTMLInputElement;
    Object.defineProperty(input, 'files', { value: [new File(['OFF'], 'elephant.off')] });
    input.dispatchEvent(new Event('change'));
    await settled();
    expect(search).toHaveBeenCalledExactlyOnceWith(
        expect.objectContaining({ name: 'elephant.off' }),
        context.parameters,
        expect.anything(),
        expect.any(Function),
        expect.stringMatching(/^[0-9a-f]{32}$/),
    );
});
