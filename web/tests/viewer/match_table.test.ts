import { expect, it, vi } from 'vitest';

import { assignBranchColors } from '../../src/viewer/branch_colors';
import { branchShares, matchTable } from '../../src/viewer/match_table';
import { kSkeleton } from '../sample';

const kColors = assignBranchColors(
    [
        { a: 1, b: 0, cost: 0.25 },
        { a: 0, b: 1, cost: 0.125 },
    ],
    kSkeleton.branches,
);

it('lists each pair with its number, both lengths and its cost', () => {
    const { node } = matchTable({
        colors: kColors,
        query: kSkeleton,
        hit: kSkeleton,
        onChoose: () => {},
        onFind: () => {},
    });
    const rows = [...node.querySelectorAll('tbody tr')].map((row) =>
        [...row.children].map((cell) => cell.textContent),
    );
    expect(rows).toEqual([
        ['1', '75.0 %', '25.0 %', '0.125', 'Find'],
        ['2', '25.0 %', '75.0 %', '0.250', 'Find'],
    ]);
});

it('points at a pair by pointer and by keyboard alike', () => {
    const onChoose = vi.fn();
    const onFind = vi.fn();
    const { node } = matchTable({
        colors: kColors,
        query: kSkeleton,
        hit: kSkeleton,
        onChoose,
        onFind,
    });
    const row = node.querySelector('tbody tr');
    for (const [type, pair] of [
        ['pointerenter', kColors.pairs[0]],
        ['pointerleave', null],
        ['focusin', kColors.pairs[0]],
        ['focusout', null],
    ] as const) {
        row?.dispatchEvent(new Event(type));
        expect(onChoose).toHaveBeenLastCalledWith(pair);
    }
    row?.querySelector('button')?.click();
    expect(onFind).toHaveBeenLastCalledWith(kColors.pairs[0]);
});

it('marks the row of the pair that is pointed at elsewhere', () => {
    const table = matchTable({
        colors: kColors,
        query: kSkeleton,
        hit: kSkeleton,
        onChoose: () => {},
        onFind: () => {},
    });
    const marked = () =>
        [...table.node.querySelectorAll('tr.chosen th')].map((th) => th.textContent);
    table.highlight(kColors.pairs[1] ?? null);
    expect(marked()).toEqual(['2']);
    table.highlight(null);
    expect(marked()).toEqual([]);
});

it('says that nothing matches, and copes with branches that are not there', () => {
    const empty = assignBranchColors([], []);
    const none = matchTable({
        colors: empty,
        query: kSkeleton,
        hit: kSkeleton,
        onChoose: () => {},
        onFind: () => {},
    });
    expect(none.node.textContent).toContain('No branches match');
    const unknown = assignBranchColors([{ a: 77, b: 78, cost: 1 }], []);
    const table = matchTable({
        colors: unknown,
        query: kSkeleton,
        hit: kSkeleton,
        onChoose: () => {},
        onFind: () => {},
    });
    expect(table.node.querySelector('tbody td')?.textContent).toBe('–');
});

it('measures branches by their share of the skeleton', () => {
    const shares = [...branchShares(kSkeleton).values()];
    expect(shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1, 9);
    const flat = { ...kSkeleton, branches: kSkeleton.branches.map((b) => ({ ...b, length: 0 })) };
    expect([...branchShares(flat).values()]).toEqual([0, 0]);
});
