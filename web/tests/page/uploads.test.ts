import { beforeEach, expect, it, vi } from 'vitest';

import { ApiError } from '../../src/api/problem';
import { kSearchDefaults } from '../../src/api/search_parameters';
import { Uploads } from '../../src/page/uploads';
import { clientWith, searchResult, settled } from '../sample';

beforeEach(() => sessionStorage.clear());

const kToken = '0123456789abcdef'.repeat(2);

function off(name: string): File {
    return new File([`OFF ${name}`], name);
}

/** A file that the browser cannot read any more, as after it was changed. */
function changedFile(name: string): File {
    const file = off(name);
    file.arrayBuffer = () => Promise.reject(new DOMException('changed', 'NotReadableError'));
    return file;
}

function uploadsWith(search: (file: File) => Promise<ReturnType<typeof searchResult>>) {
    const uploads = new Uploads(clientWith({ search }));
    const shown: string[] = [];
    uploads.onDone = ({ name }) => void shown.push(name);
    return { uploads, shown };
}

it('searches with one file after the other, and shows the first of them', async () => {
    const sent: string[] = [];
    const { uploads, shown } = uploadsWith(async (file) => {
        sent.push(await file.text());
        return { ...searchResult(), token: kToken };
    });
    uploads.take([off('a.off'), off('b.off')], kSearchDefaults);
    expect(uploads.list.map(({ state }) => state)).toEqual(['running', 'waiting']);
    await settled();
    expect(sent).toEqual(['OFF a.off', 'OFF b.off']);
    expect(shown).toEqual(['a.off']);
    expect(uploads.find(kToken)?.name).toBe('a.off');
});

it('says of a file that cannot be read that the file is at fault, and goes on', async () => {
    const { uploads, shown } = uploadsWith(async () => searchResult());
    uploads.take([changedFile('old.off'), off('b.off')], kSearchDefaults);
    await settled();
    const [first] = uploads.list;
    expect(first?.state).toBe('failed');
    expect((first?.error as ApiError).code).toBe('local_file');
    expect((first?.error as ApiError).message).toContain('old.off');
    expect(shown).toEqual(['b.off']);
});

it('keeps the bytes: what becomes of the file later is of no consequence', async () => {
    const search = vi.fn(async (_file: File) => ({ ...searchResult(), token: kToken }));
    const { uploads } = uploadsWith(search);
    const file = off('a.off');
    uploads.take([file], kSearchDefaults);
    await settled();
    file.arrayBuffer = () => Promise.reject(new DOMException('gone', 'NotFoundError'));
    const [upload] = uploads.list;
    expect(await uploads.again(upload as never, { ...kSearchDefaults, pose: 1 })).not.toBeNull();
    expect(await search.mock.calls[1]?.[0].text()).toBe('OFF a.off');
});

it('goes on with the next file where one is refused, and where one is cancelled', async () => {
    const refusal = new ApiError({ title: 'No', status: 422, detail: '', code: 'off_truncated' });
    const client = clientWith({
        search: (file, _parameters, signal) =>
            file.name === 'bad.off'
                ? Promise.reject(refusal)
                : new Promise((resolve, reject) => {
                      signal?.addEventListener('abort', () =>
                          reject(new DOMException('stopped', 'AbortError')),
                      );
                      if (file.name === 'good.off') {
                          resolve(searchResult());
                      }
                  }),
    });
    const uploads = new Uploads(client);
    uploads.take([off('bad.off'), off('slow.off'), off('good.off')], kSearchDefaults);
    await settled();
    expect(uploads.list.map(({ state }) => state)).toEqual(['failed', 'running', 'waiting']);
    uploads.remove(uploads.list[1] as never);
    await settled();
    expect(uploads.list.map(({ name, state }) => `${name} ${state}`)).toEqual([
        'bad.off failed',
        'good.off done',
    ]);
});

it('remembers for the session where the server keeps them', async () => {
    const { uploads } = uploadsWith(async () => ({ ...searchResult(), token: kToken }));
    uploads.take([off('a.off')], kSearchDefaults);
    await settled();
    const later = new Uploads(clientWith({}));
    expect(later.find(kToken)?.name).toBe('a.off');
    expect(await later.again(later.find(kToken) as never, kSearchDefaults)).toBeNull();
    sessionStorage.setItem('ossuary.uploads', '{');
    expect(new Uploads(clientWith({})).list).toEqual([]);
});
