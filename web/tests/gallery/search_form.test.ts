import { expect, it, vi } from 'vitest';

import { kSearchDefaults, type SearchParameters } from '../../src/api/search_parameters';
import { searchForm } from '../../src/gallery/search_form';
import { KnownFacets } from '../../src/page/known_facets';
import { clientWith } from '../sample';

const kOther: SearchParameters = {
    ranker: 'chain-code',
    pose: 0.8,
    size: 1,
    rerank: true,
    part: true,
    fold: false,
    limit: 96,
    className: 'table',
    folder: 'old/oak',
    kind: 'stl',
    order: 'faces',
};

it.each([kSearchDefaults, kOther, { ...kSearchDefaults, limit: 7 }])(
    'shows the parameters that it was given: %j',
    (parameters) => {
        expect(searchForm(new KnownFacets(clientWith({})), { parameters }).parameters).toEqual(
            parameters,
        );
    },
);

it('tells of a choice once it is made', () => {
    const onChange = vi.fn();
    const { node } = searchForm(new KnownFacets(clientWith({})), { onChange });
    document.body.append(node);
    const pose = node.querySelector<HTMLInputElement>('[name=pose]');
    if (!pose) {
        throw new Error('no slider');
    }
    pose.value = '0.6';
    pose.dispatchEvent(new Event('input', { bubbles: true }));
    expect(onChange).not.toHaveBeenCalled();
    expect(node.querySelector('output')?.textContent).toBe('0.60');
    pose.dispatchEvent(new Event('change', { bubbles: true }));
    expect(onChange).toHaveBeenCalledExactlyOnceWith({ ...kSearchDefaults, pose: 0.6 });
    node.remove();
});

it('does not leave the page on Enter', () => {
    const onChange = vi.fn();
    const { node } = searchForm(new KnownFacets(clientWith({})), { parameters: kOther, onChange });
    const submit = new Event('submit', { cancelable: true });
    node.dispatchEvent(submit);
    expect(submit.defaultPrevented).toBe(true);
    expect(onChange).toHaveBeenCalledExactlyOnceWith(kOther);
});

it('labels every control', () => {
    const { node } = searchForm(new KnownFacets(clientWith({})));
    for (const control of node.querySelectorAll('input, select')) {
        expect(control.closest('label')?.textContent?.trim()).toBeTruthy();
    }
});
