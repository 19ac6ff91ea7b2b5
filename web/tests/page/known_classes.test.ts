import { expect, it, vi } from 'vitest';

import { KnownClasses } from '../../src/page/known_classes';

it('collects each class once, in alphabetical order', () => {
    const classes = new KnownClasses();
    classes.add(['table', null, 'ant', '']);
    classes.add(['ant', 'bird']);
    expect(classes.names).toEqual(['ant', 'bird', 'table']);
});

it('tells its listeners only of what is new, until they leave', () => {
    const classes = new KnownClasses();
    const listener = vi.fn();
    const leave = classes.subscribe(listener);
    classes.add(['ant']);
    classes.add(['ant', null]);
    expect(listener).toHaveBeenCalledOnce();
    leave();
    classes.add(['bird']);
    expect(listener).toHaveBeenCalledOnce();
});
