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

it('tells the stage, and how far it is where that is known', () => {
    const { node, stage, dispose } = progress({ message: 'Searching' });
    const bar = node.querySelector('.progress-bar');
    stage('Sending', 0.45);
    expect(node.textContent).toContain('Sending');
    expect(bar?.getAttribute('aria-valuenow')).toBe('45');
    stage('Ranking', null);
    expect(node.textContent).toContain('Ranking');
    expect(bar?.hasAttribute('aria-valuenow')).toBe(false);
    dispose();
});

it('can be cancelled', () => {
    const onCancel = vi.fn();
    const { node, dispose } = progress({ onCancel });
    node.querySelector('button')?.click();
    dispose();
    expect(onCancel).toHaveBeenCalledOnce();
});
