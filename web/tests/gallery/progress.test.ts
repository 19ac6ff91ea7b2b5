import { afterEach, expect, it, vi } from 'vitest';

import { progress } from '../../src/gallery/progress';

afterEach(() => {
    vi.useRealTimers();
});

it('counts the time until it is taken down', () => {
    vi.useFakeTimers();
    const { node, dispose } = progress({ message: 'Searching' });
    const elapsed = () => node.querySelector('.number')?.textContent;
    vi.advanceTimersByTime(1250);
    expect(elapsed()).toBe('1.2 s');
    vi.advanceTimersByTime(20_000);
    expect(elapsed()).toBe('21 s');
    dispose();
    vi.advanceTimersByTime(5000);
    expect(elapsed()).toBe('21 s');
});

it('can be cancelled', () => {
    const onCancel = vi.fn();
    const { node, dispose } = progress({ onCancel });
    node.querySelector('button')?.click();
    dispose();
    expect(onCancel).toHaveBeenCalledOnce();
});
