import { expect, it, vi } from 'vitest';

import { ApiError, unreachable } from '../../src/api/problem';
import { emptyNotice, problemNotice } from '../../src/page/problem_notice';

const kProblem = new ApiError({
    title: 'The model cannot be read',
    status: 422,
    detail: 'line 3: expected 3 numbers',
    code: 'off_truncated',
    request_id: 'r-1',
});

it('shows code, detail and request id, and says them at once', () => {
    const node = problemNotice(kProblem);
    expect(node.getAttribute('role')).toBe('alert');
    expect(node.querySelector('code')?.textContent).toBe('off_truncated');
    expect(node.textContent).toContain('line 3: expected 3 numbers');
    expect(node.textContent).toContain('r-1');
    expect(node.querySelector('button')).toBeNull();
});

it('offers to try again where that makes sense', () => {
    const retry = vi.fn();
    problemNotice(unreachable(), { retry }).querySelector('button')?.click();
    expect(retry).toHaveBeenCalledOnce();
});

it('shows failures of the page itself too', () => {
    expect(problemNotice(new Error('boom')).textContent).toContain('boom');
    expect(problemNotice('odd').textContent).toContain('odd');
});

it('tells of emptiness without an alarm', () => {
    const node = emptyNotice('Nothing here', 'yet');
    expect(node.hasAttribute('role')).toBe(false);
    expect(node.textContent).toBe('Nothing hereyet');
});
