import { expect, it } from 'vitest';

import { metricsTable } from '../../src/reports/metrics_table';
import { evaluation } from '../sample';

it('shows six figures for each ranker, marks the best, and links the curve’s files', () => {
    const node = metricsTable([
        evaluation({ ranker: 'hybrid', dcg: 0.9 }),
        evaluation({ ranker: 'chain-code', dcg: 0.4 }),
    ]);
    const rows = [...node.querySelectorAll('tbody tr')];
    expect(rows.map((row) => row.querySelector('th')?.textContent)).toEqual([
        'Hybrid',
        'Chain code',
    ]);
    for (const row of rows) {
        expect(row.querySelectorAll('td.number')).toHaveLength(6);
    }
    expect([...node.querySelectorAll('.best')].map((cell) => cell.firstChild?.textContent)).toEqual(
        ['0.900'],
    );
    expect(node.querySelector('.interval')?.textContent).toBe('0.400–0.600');
    const links = [...node.querySelectorAll('a')].map((link) => link.getAttribute('href'));
    expect(links).toContain('/v1/evaluations/chain-code.csv');
    expect(links).toContain('/v1/evaluations/hybrid.svg');
});
