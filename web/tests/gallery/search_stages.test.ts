import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import { followStages, nameOfStage } from '../../src/gallery/search_stages';

beforeEach(() => {
    vi.useFakeTimers();
});

afterEach(() => {
    vi.useRealTimers();
});

it('tells each new stage, goes forward alone, and ends when it is told to', async () => {
    const stages = [null, 'wait', 'read', 'read', 'thin', 'global_descriptors', 'turned_skeletons'];
    const progress = vi.fn(async () => ({ stage: stages.shift() ?? null }));
    const told: string[] = [];
    const stop = new AbortController();
    const done = followStages({ progress }, 'f'.repeat(32), (each) => told.push(each), stop.signal);
    await vi.advanceTimersByTimeAsync(5000);
    expect(told).toEqual(['wait', 'read', 'thin', 'global_descriptors']);
    stop.abort();
    await vi.advanceTimersByTimeAsync(1000);
    await done;
    const asked = progress.mock.calls.length;
    await vi.advanceTimersByTimeAsync(5000);
    expect(progress).toHaveBeenCalledTimes(asked);
});

it('goes on where the server does not answer once', async () => {
    const progress = vi
        .fn(async () => ({ stage: 'rank' as string | null }))
        .mockRejectedValueOnce(new Error('away'));
    const told: string[] = [];
    const stop = new AbortController();
    void followStages({ progress }, 'f'.repeat(32), (each) => told.push(each), stop.signal);
    await vi.advanceTimersByTimeAsync(500);
    stop.abort();
    expect(told).toEqual(['rank']);
});

it('says how far a stage is on the way', () => {
    expect(nameOfStage('thin')).toBe('thin (step 4 of 12)');
    expect(nameOfStage('wait')).toBe('waits until other searches are done');
    expect(nameOfStage('new_stage')).toBe('new stage');
});
