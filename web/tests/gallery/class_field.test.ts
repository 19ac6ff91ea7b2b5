import { expect, it } from 'vitest';

import { classField } from '../../src/gallery/class_field';
import { KnownClasses } from '../../src/page/known_classes';

it('suggests the classes seen so far and those seen later', () => {
    const classes = new KnownClasses();
    classes.add(['table']);
    const { node, input, dispose } = classField('chair', classes);
    const suggested = () => [...node.querySelectorAll('option')].map((option) => option.value);
    expect(input.value).toBe('chair');
    expect(suggested()).toEqual(['table']);
    classes.add(['ant']);
    expect(suggested()).toEqual(['ant', 'table']);
    dispose();
    classes.add(['bird']);
    expect(suggested()).toEqual(['ant', 'table']);
});

it('ties each field to a list of its own', () => {
    const classes = new KnownClasses();
    const ids = [classField('', classes), classField('', classes)].map(({ input }) =>
        input.getAttribute('list'),
    );
    expect(new Set(ids).size).toBe(2);
});
