import { expect, it } from 'vitest';

import { Recent } from '../../src/page/recent';

it('keeps the last few, each for a while', () => {
    let now = 0;
    const recent = new Recent<number>(2, 100, () => now);
    recent.set('a', 1);
    recent.set('b', 2);
    recent.set('a', 3);
    recent.set('c', 4);
    expect([recent.get('a'), recent.get('b'), recent.get('c')]).toEqual([3, undefined, 4]);
    now = 100;
    expect(recent.get('a')).toBe(3);
    now = 101;
    expect(recent.get('a')).toBeUndefined();
});
