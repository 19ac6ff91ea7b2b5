import { expect, it } from 'vitest';

import { modelCard } from '../../src/gallery/model_card';
import { parseRoute } from '../../src/page/routes';
import { Selection } from '../../src/page/selection';
import { model } from '../sample';

const kNone = new Selection();

it('leads to the models that are similar, and is named after its own', () => {
    const card = modelCard(model(7, { name: 'ele<b>phant', branches: 1 }), kNone);
    const link = card.querySelector('a');
    expect(parseRoute(link?.getAttribute('href') ?? '')).toMatchObject({
        page: 'results',
        query: { kind: 'model', id: 7 },
        over: null,
    });
    expect(link?.textContent).toContain('ele<b>phant');
    expect(link?.textContent).toContain('1 branch');
    expect(link?.textContent).not.toContain('branches');
});

it('shows no tag for a model without a class', () => {
    expect(modelCard(model(7), kNone).querySelector('.tag')?.textContent).toBe('chair');
    expect(modelCard(model(7, { class: null }), kNone).querySelector('.tag')).toBeNull();
});

it('says in which folder a model lies, or in which file with others', () => {
    const lineOf = (path: string) =>
        modelCard({ ...model(7), path }, kNone).querySelector('.card-file')?.textContent;
    expect(lineOf('chairs/old/leg.off')).toBe('chairs/old');
    expect(lineOf('prints/plate.3mf#left/Wheel')).toBe('prints/plate.3mf');
    expect(lineOf('toys.ZIP#car.glb#Wheel')).toBe('toys.ZIP');
    expect(lineOf('a#1/b.off')).toBe('a#1');
    expect(lineOf('plate.3mf')).toBe('');
    expect(lineOf('')).toBe('');
});
