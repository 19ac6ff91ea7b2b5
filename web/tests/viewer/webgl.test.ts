import { afterEach, beforeEach, expect, it, vi } from 'vitest';

beforeEach(() => {
    vi.resetModules();
});

afterEach(() => {
    vi.restoreAllMocks();
});

async function fresh() {
    return (await import('../../src/viewer/webgl')).hasWebGl;
}

it('asks the browser once, and gives the context back', async () => {
    const hasWebGl = await fresh();
    const loseContext = vi.fn();
    const context = { getExtension: () => ({ loseContext }) };
    const asked = vi
        .spyOn(HTMLCanvasElement.prototype, 'getContext')
        .mockReturnValue(context as never);
    expect([hasWebGl(), hasWebGl(), hasWebGl()]).toEqual([true, true, true]);
    expect(asked).toHaveBeenCalledOnce();
    expect(loseContext).toHaveBeenCalledOnce();
});

it('takes no for an answer', async () => {
    const hasWebGl = await fresh();
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(null);
    expect(hasWebGl()).toBe(false);
});
