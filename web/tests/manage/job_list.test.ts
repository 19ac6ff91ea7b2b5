import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import type { Administration, ListedJob } from '../../src/api/administration';
import { unreachable } from '../../src/api/problem';
import { JobList } from '../../src/manage/job_list';

let list: JobList | null = null;

beforeEach(() => {
    vi.useFakeTimers();
});

afterEach(() => {
    list?.dispose();
    vi.useRealTimers();
});

function job(id: number, changes: Partial<ListedJob> = {}): ListedJob {
    return {
        id,
        state: 'done',
        model: 10 + id,
        error: null,
        name: `model${id}`,
        class: 'ant',
        size: 12_345,
        accepted_at: '2026-05-01T12:00:00Z',
        finished_at: '2026-05-01T12:00:05Z',
        ...changes,
    };
}

async function open(jobs: Administration['jobs']) {
    list = new JobList(() => ({ jobs }) as Administration);
    await list.look();
    return list.node;
}

it('shows what was added, by whomever, and why it failed', async () => {
    const error = { code: 'mesh_empty', message: 'it has no triangle' };
    const node = await open(async () => [
        job(3, { state: 'running', model: null, finished_at: null }),
        job(2, { state: 'failed', model: null, error }),
        job(1),
    ]);
    const rows = [...node.querySelectorAll('tbody tr')].map((row) => row.textContent ?? '');
    expect(rows[0]).toContain('is being indexed');
    expect(rows[1]).toContain('mesh_empty');
    expect(rows[1]).toContain('it has no triangle');
    expect(rows[2]).toContain('12.3 kB');
    expect(node.querySelector('tbody a')?.getAttribute('href')).toBe('#/models/11');
    expect(node.querySelector('time')?.getAttribute('datetime')).toBe('2026-05-01T12:00:00Z');
});

it('looks again, soon while something is on its way, and keeps what has not changed', async () => {
    const jobs = vi.fn(async () => [job(1, { state: 'queued', model: null })]);
    const node = await open(jobs);
    const table = node.querySelector('table');
    await vi.advanceTimersByTimeAsync(2000);
    expect(jobs).toHaveBeenCalledTimes(2);
    expect(node.querySelector('table')).toBe(table);
    jobs.mockResolvedValue([job(1)]);
    await vi.advanceTimersByTimeAsync(2000);
    expect(node.textContent).toContain('is in the collection');
    await vi.advanceTimersByTimeAsync(14_000);
    expect(jobs).toHaveBeenCalledTimes(3);
    list?.dispose();
    await vi.advanceTimersByTimeAsync(60_000);
    expect(jobs).toHaveBeenCalledTimes(3);
});

it('says where there is nothing, and where the server is away', async () => {
    const jobs = vi.fn(async (): Promise<ListedJob[]> => []);
    const node = await open(jobs);
    expect(node.textContent).toBe('Nothing was added yet.');
    jobs.mockRejectedValue(unreachable());
    await vi.advanceTimersByTimeAsync(15_000);
    expect(node.querySelector('.notice-problem')).not.toBeNull();
});
