import { expect, it } from 'vitest';

import { modelCard } from '../../src/gallery/model_card';
import { parseRoute } from '../../src/page/routes';
import { model } from '../sample';

it('leads to the models that are similar, and is named after its own', () => {
    const card = modelCard(model(7, { name: 'ele<b>phant', branches: 1 }));
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
    expect(modelCard(model(7)).querySelector('.tag')?.textContent).toBe('chair');
    expect(modelCard(model(7, { class: null })).querySelector('.tag')).toBeNull();
});

it('names the file that a model shares with others', () => {
    const lineOf = (path: string) =>
        modelCard({ ...model(7), path }).querySelector('.card-file')?.textContent;
    expect(lineOf('/models/plate.3mf#left/Wheel')).toBe('in plate.3mf');
    expect(lineOf('/models/toys.ZIP#car.glb#Wheel')).toBe('in toys.ZIP');
    expect(lineOf('/models/a#1/b.off')).toBeUndefined();
    expect(lineOf('/models/plate.3mf')).toBeUndefined();
    expect(lineOf('')).toBeUndefined();
});
