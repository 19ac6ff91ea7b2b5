import { expect, it, vi } from 'vitest';

import type { QueryMetrics, SearchResult } from '../../src/api/types';
import { barsSvg } from '../../src/reports/bars_svg';
import { classBars } from '../../src/reports/class_bars';
import { ConfusedModels, confusedModels } from '../../src/reports/confused_models';
import { comparedQueries, queryComparison } from '../../src/reports/query_comparison';
import { clientWith, evaluation, hit, searchResult, settled } from '../sample';

function query(model: number, precision: number, fields: Partial<QueryMetrics> = {}): QueryMetrics {
    return {
        model,
        name: `m${model}`,
        class: 'ant',
        nearest_neighbor: 1,
        first_tier: 1,
        second_tier: 1,
        e_measure: 1,
        dcg: 1,
        mean_average_precision: precision,
        ...fields,
    };
}

it('puts those queries first on which the rankers differ most', () => {
    const found = comparedQueries([
        [query(1, 0.5), query(2, 0.9), query(3, 0.4)],
        [query(3, 0.5), query(2, 0.2)],
    ]);
    expect(found.map(({ model }) => model)).toEqual([2, 3]);
    expect(found[0]?.precisions).toEqual([0.9, 0.2]);
    expect(comparedQueries([])).toEqual([]);
});

it('asks for them once it is opened, and leads to the results by each ranker', async () => {
    const evaluatedQueries = vi.fn(async () => [query(1, 0.5)]);
    const evaluations = [evaluation(), evaluation({ ranker: 'chain-code' })];
    const { signal } = new AbortController();
    const node = queryComparison(evaluations, clientWith({ evaluatedQueries }), signal);
    expect(evaluatedQueries).not.toHaveBeenCalled();
    (node as HTMLDetailsElement).open = true;
    node.dispatchEvent(new Event('toggle'));
    await settled();
    const links = [...node.querySelectorAll('tbody a')].map((a) => a.getAttribute('href'));
    expect(links).toEqual(['#/models/1', '#/models/1?ranker=chain-code']);
});

const kNearest = (id: number): SearchResult =>
    searchResult([hit(1, { id, name: `n${id}`, class: id === 50 ? 'bee' : 'wasp' })]);

it('finds the models behind a cell: of that class, and nearest to one of the other', async () => {
    const client = clientWith({
        evaluatedQueries: async () => [
            query(1, 1),
            query(2, 0.3, { nearest_neighbor: 0 }),
            query(3, 0.3, { nearest_neighbor: 0 }),
            query(4, 0.3, { nearest_neighbor: 0, class: 'bee' }),
        ],
        similar: async (model) => kNearest(model.kind === 'model' && model.id === 2 ? 50 : 51),
    });
    const { signal } = new AbortController();
    const pairs = await confusedModels(client, 'hybrid', { from: 'ant', to: 'bee' }, signal);
    expect(pairs.map((pair) => [pair.query.model, pair.nearest.id])).toEqual([[2, 50]]);
    const shown = new ConfusedModels(client, 'skeleton');
    await shown.show('ant', 'bee');
    expect(shown.node.querySelector('a')?.getAttribute('href')).toBe(
        '#/models/2/hits/50?ranker=skeleton',
    );
});

it('has a bar for each class and ranker, of the measure that is chosen', () => {
    const node = classBars([evaluation(), evaluation({ ranker: 'chain-code' })]);
    const bars = node.querySelectorAll('.class-bar');
    expect(bars).toHaveLength(2 * node.querySelectorAll('dt').length);
    expect(bars[0]?.getAttribute('aria-label')).toMatch(/^hybrid /);
});

it('draws bars that stay within the picture and names that stay text', () => {
    const svg = barsSvg(['<b>', 'ok'], [{ name: 'a & b', color: '#123456', values: [7, -1] }]);
    expect(svg).toContain('&lt;b&gt;');
    expect(svg).toContain('a &amp; b');
    const widths = [...svg.matchAll(/width="([0-9.]+)" height="7"/g)].map(([, width]) => width);
    expect(widths).toEqual(['440.0', '0.0']);
});
