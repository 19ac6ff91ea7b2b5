import { expect, it, vi } from 'vitest';

import { csvOf, saveResults } from '../../src/gallery/save_results';
import { hit, searchResult } from '../sample';

it('has a line for each hit, with quotes where they are needed', () => {
    const lines = csvOf([
        hit(1, { name: 'a "b", c', class: null, distance: 0.25, copies: 2 }),
        hit(2, { build_difference: null, pose_difference: null }),
    ]).split('\r\n');
    expect(lines).toEqual([
        'rank,id,name,class,path,distance,build_difference,pose_difference,matched_nodes,faces,copies',
        '1,101,"a ""b"", c",,chairs/hit1.off,0.25,0.4,0.8,2,20,2',
        '2,102,hit2,chair,chairs/hit2.off,0.2,,,2,20,0',
        '',
    ]);
});

it('gives no spreadsheet a formula, and leaves numbers alone', () => {
    const line = csvOf([hit(1, { name: '=1+1', distance: -0.5 })]).split('\r\n')[1];
    expect(line).toContain(",'=1+1,");
    expect(line).toContain(',-0.5,');
});

it('saves a file under the name of the query', async () => {
    const saved: Blob[] = [];
    vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
        saved.push(blob as Blob);
        return 'blob:x';
    });
    const names: string[] = [];
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (
        this: HTMLAnchorElement,
    ) {
        names.push(this.download);
    });
    for (const button of saveResults(searchResult()).querySelectorAll('button')) {
        button.click();
    }
    expect(names).toEqual(['like-elephant.csv', 'like-elephant.json']);
    expect(await saved[0]?.text()).toMatch(/^rank,id,/);
    expect(JSON.parse((await saved[1]?.text()) ?? '')).toEqual(searchResult());
    vi.restoreAllMocks();
});
