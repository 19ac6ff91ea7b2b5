import { expect, it } from 'vitest';

import { comparison } from '../../src/viewer/comparison';
import { hit, kMesh, kSkeleton } from '../sample';

const kSide = { name: 'elephant', mesh: kMesh, skeleton: kSkeleton, up: 'y', unit: null } as const;

it('works without WebGL: a plain message in the place of the pictures, and the tables', () => {
    const { match } = hit(1);
    const note = document.createElement('p');
    const view = comparison({ query: kSide, hit: kSide, match, note, onFind: () => {} });
    expect(view.node.querySelector('.no-webgl')).not.toBeNull();
    expect(view.node.querySelector('canvas')).toBeNull();
    expect(view.node.querySelectorAll('.match-table tbody tr')).toHaveLength(1);
    expect(view.node.contains(note)).toBe(true);
    view.dispose();
});

it('says how much matches, and in how many groups', () => {
    const note = document.createElement('p');
    const text = (cluster_sizes: number[]) =>
        comparison({
            query: kSide,
            hit: kSide,
            match: { nodes: [], branches: [{ a: 0, b: 0, cost: 0 }], cluster_sizes },
            note,
            onFind: () => {},
        }).node.querySelector('.match-summary')?.textContent;
    expect(text([])).toBe('1 branch and 0 nodes match.');
    expect(text([5, 2])).toContain('2 groups of 5, 2 nodes');
});
