import { afterEach, expect, it, vi } from 'vitest';

import { hasWebGl } from '../../src/viewer/webgl';

afterEach(() => {
    vi.restoreAllMocks();
});

it('asks the browser, and gives the context back', () => {
    const loseContext = vi.fn();
    const context = { getExtension: () => ({ loseContext }) };
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(context as never);
    expect(hasWebGl()).toBe(true);
    expect(loseContext).toHaveBeenCalledOnce();
});

it('takes no for an answer', () => {
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(null);
    expect(hasWebGl()).toBe(false);
});
