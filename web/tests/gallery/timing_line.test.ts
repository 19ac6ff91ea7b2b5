import { expect, it } from 'vitest';

import { timedStages, timingLine } from '../../src/gallery/timing_line';
import { searchResult } from '../sample';

it('says how many models were ranked in what time, and what the time went to', () => {
    const text = timingLine(searchResult()).textContent;
    expect(text).toContain('380 models ranked in 84 ms');
    expect(text).toContain('thin 80 ms');
});

it('names the stages as a model goes through them, whatever order they come in', () => {
    const stages = timedStages({ explain: 1, rank: 1, dream: 1, read: 1, thin: 1, voxelize: 1 });
    expect(stages.map(([stage]) => stage)).toEqual([
        'read',
        'voxelize',
        'thin',
        'rank',
        'explain',
        'dream',
    ]);
});

it('leaves out stages that did not run', () => {
    expect(timedStages({ read: 0, thin: 3, rank: Number.NaN })).toEqual([['thin', 3]]);
    const result = { ...searchResult(), stages_ms: {} };
    expect(timingLine(result).querySelector('ul')).toBeNull();
});
