import type { Correspondence, PreviewMesh, Skeleton } from '../api/types';
import { type Child, element } from '../page/element';
import { formatDistance, formatPlural } from '../page/format';
import { assignBranchColors, type ColoredPair } from './branch_colors';
import { dialogContent } from './dialog_content';
import { matchTable } from './match_table';
import { kFirstOrbit } from './orbit';
import { OrbitSource } from './orbit_input';
import { Pane } from './pane';
import { partsList } from './parts_list';
import type { ScreenPoint } from './pick';
import { noWebGlNotice } from './query_view';
import { toggle } from './toggle';
import { hasWebGl } from './webgl';

export interface ComparedModel {
    name: string;
    mesh: PreviewMesh | null;
    skeleton: Skeleton;
}

export interface ComparisonInput {
    query: ComparedModel;
    hit: ComparedModel;
    match: Correspondence;
    parts: Record<string, number>;
}

export interface Comparison {
    node: HTMLElement;
    dispose(): void;
}

interface Side {
    pane: Pane;
    label: HTMLElement;
    pairOf: ReadonlyMap<number, ColoredPair>;
    branchOf: (pair: ColoredPair) => number;
    figure: HTMLElement;
}

function summary(input: ComparisonInput): string {
    const clusters = input.match.cluster_sizes;
    const nodes = formatPlural(input.match.nodes.length, 'node');
    const branches = formatPlural(input.match.branches.length, 'branch', 'branches');
    return clusters.length > 1
        ? `${branches} and ${nodes} match, in ${clusters.length} groups of ${clusters.join(', ')} nodes.`
        : `${branches} and ${nodes} match.`;
}

/**
 * Query and hit side by side, matched branches in one colour, with the table of the matches. The
 * three ways to point at a branch (left picture, right picture, table) do the same.
 */
export function comparison(input: ComparisonInput): Comparison {
    const colors = assignBranchColors(input.match.branches, input.query.skeleton.branches);
    const sides: Side[] = [];
    const table = matchTable({
        colors,
        query: input.query.skeleton,
        hit: input.hit.skeleton,
        onChoose: (pair) => choose(pair),
    });

    function choose(pair: ColoredPair | null, only?: { side: Side; branch: number }): void {
        table.highlight(pair);
        for (const side of sides) {
            const alone = only?.side === side ? only.branch : null;
            side.pane.highlight(pair ? side.branchOf(pair) : alone);
        }
    }

    function hovered(index: number, branch: number | null, at: ScreenPoint | null): void {
        const side = sides[index];
        if (!side) {
            return;
        }
        const pair = branch === null ? null : (side.pairOf.get(branch) ?? null);
        choose(pair, branch === null ? undefined : { side, branch });
        side.label.hidden = at === null;
        if (at) {
            side.label.style.setProperty('--x', `${at.x}px`);
            side.label.style.setProperty('--y', `${at.y}px`);
            side.label.textContent = pair
                ? `Branch ${pair.number} · cost ${formatDistance(pair.cost)}`
                : 'No counterpart';
        }
    }

    function addSide(
        model: ComparedModel,
        role: string,
        pairOf: ReadonlyMap<number, ColoredPair>,
        branchOf: (pair: ColoredPair) => number,
    ): void {
        const index = sides.length;
        const label = element('span', { class: 'pane-label', hidden: true });
        const pane = new Pane({
            mesh: model.mesh,
            skeleton: model.skeleton,
            branchColors: new Map([...pairOf].map(([id, pair]) => [id, pair.color])),
            label: `${role}: ${model.name} with its skeleton`,
            orbit: shared,
            onHover: (branch, at) => hovered(index, branch, at),
        });
        pane.node.append(label);
        const figure = element(
            'figure',
            { class: 'side' },
            pane.node,
            element('figcaption', {}, element('span', {}, role), ' ', model.name),
        );
        sides.push({ pane, label, pairOf, branchOf, figure });
    }

    const shared = new OrbitSource();
    const parts = { surface: true, nodes: true };
    const showParts = (): void => {
        for (const { pane } of sides) {
            pane.show(parts);
        }
    };
    let stage: Child = noWebGlNotice();
    if (hasWebGl()) {
        addSide(input.query, 'Query', colors.query, (pair) => pair.a);
        addSide(input.hit, 'Hit', colors.hit, (pair) => pair.b);
        stage = [
            element(
                'div',
                { class: 'sides' },
                sides.map(({ figure }) => figure),
            ),
            element(
                'div',
                { class: 'viewer-controls', role: 'group', 'aria-label': 'View' },
                toggle('Turn together', true, (together) => {
                    const { orbit } = sides[0]?.pane.orbit ?? shared;
                    shared.set(orbit);
                    for (const { pane } of sides) {
                        pane.follow(together ? shared : new OrbitSource(orbit));
                    }
                }),
                toggle('Surface', true, (on) => {
                    parts.surface = on;
                    showParts();
                }),
                toggle('Nodes', true, (on) => {
                    parts.nodes = on;
                    showParts();
                }),
                element(
                    'button',
                    {
                        type: 'button',
                        class: 'button button-quiet',
                        click: () => {
                            for (const { pane } of sides) {
                                pane.orbit.set({ ...kFirstOrbit });
                            }
                        },
                    },
                    'Reset view',
                ),
            ),
        ];
    }
    return {
        node: dialogContent(
            stage,
            element('p', { class: 'match-summary' }, summary(input)),
            partsList(input.parts),
            table.node,
        ),
        dispose() {
            for (const { pane } of sides) {
                pane.dispose();
            }
        },
    };
}
