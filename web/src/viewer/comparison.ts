import '../styles/viewer.css';
import type { Match } from '../api/types';
import { element } from '../page/element';
import { formatDistance, formatPlural, formatSize } from '../page/format';
import { assignBranchColors, type BranchColors, type ColoredPair } from './branch_colors';
import { dialogContent } from './dialog_content';
import { type MatchTable, matchTable } from './match_table';
import { kFirstOrbit } from './orbit';
import { OrbitSource } from './orbit_input';
import { Pane } from './pane';
import type { ScreenPoint } from './pick';
import { noWebGlNotice, type ViewedModel } from './query_view';
import { toggle } from './toggle';
import { hasWebGl } from './webgl';

export interface ComparisonInput {
    query: ViewedModel;
    hit: ViewedModel;
    match: Match;
    /** Said of the comparison between its summary and its table. */
    note: HTMLElement;
}

export interface Comparison {
    node: HTMLElement;
    dispose(): void;
}

interface SideOptions {
    role: string;
    model: ViewedModel;
    pairOf: ReadonlyMap<number, ColoredPair>;
    branchOf: (pair: ColoredPair) => number;
}

interface Side extends SideOptions {
    pane: Pane;
    label: HTMLElement;
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

/** Two pictures and a table: a branch that one of them points at is lit in all. */
class LinkedBranches {
    readonly table: MatchTable;
    readonly sides: Side[] = [];
    /** Where both stand while they turn together. */
    readonly orbit = new OrbitSource();

    constructor(input: ComparisonInput, colors: BranchColors) {
        this.table = matchTable({
            colors,
            query: input.query.skeleton,
            hit: input.hit.skeleton,
            onChoose: (pair) => this.choose(pair),
        });
    }

    addSide(options: SideOptions): void {
        const { role, model, pairOf } = options;
        const label = element('span', { class: 'pane-label', hidden: true });
        const pane = new Pane({
            mesh: model.mesh,
            skeleton: model.skeleton,
            branchColors: new Map([...pairOf].map(([id, pair]) => [id, pair.color])),
            label: `${role}: ${model.name} with its skeleton`,
            orbit: this.orbit,
            up: model.up,
            onHover: (branch, at) => this.hovered(side, branch, at),
        });
        pane.node.append(label);
        const figure = element(
            'figure',
            { class: 'side' },
            pane.node,
            element(
                'figcaption',
                { title: model.name },
                element('span', {}, role),
                ' ',
                model.name,
                model.mesh &&
                    element(
                        'span',
                        { class: 'fine' },
                        ` ${formatSize(model.mesh.bounds, model.unit)}`,
                    ),
            ),
        );
        const side: Side = { ...options, pane, label, figure };
        this.sides.push(side);
    }

    dispose(): void {
        for (const { pane } of this.sides) {
            pane.dispose();
        }
    }

    private choose(pair: ColoredPair | null, only?: { side: Side; branch: number }): void {
        this.table.highlight(pair);
        for (const side of this.sides) {
            const alone = only?.side === side ? only.branch : null;
            side.pane.highlight(pair ? side.branchOf(pair) : alone);
        }
    }

    private hovered(side: Side, branch: number | null, at: ScreenPoint | null): void {
        const pair = branch === null ? null : (side.pairOf.get(branch) ?? null);
        this.choose(pair, branch === null ? undefined : { side, branch });
        side.label.hidden = at === null;
        if (at) {
            side.label.style.setProperty('--x', `${at.x}px`);
            side.label.style.setProperty('--y', `${at.y}px`);
            side.label.textContent = pair
                ? `Branch ${pair.number} · cost ${formatDistance(pair.cost)}`
                : 'No counterpart';
        }
    }
}

function controls(sides: readonly Side[], shared: OrbitSource): HTMLElement {
    const parts = { surface: true, nodes: true };
    const show = (changed: Partial<typeof parts>): void => {
        Object.assign(parts, changed);
        for (const { pane } of sides) {
            pane.show(parts);
        }
    };
    const turnTogether = (together: boolean): void => {
        const { orbit } = sides[0]?.pane.orbit ?? shared;
        shared.set(orbit);
        for (const { pane } of sides) {
            pane.follow(together ? shared : new OrbitSource(orbit));
        }
    };
    const reset = (): void => {
        for (const { pane } of sides) {
            pane.orbit.set({ ...kFirstOrbit });
        }
    };
    return element(
        'div',
        { class: 'viewer-controls', role: 'group', 'aria-label': 'View' },
        toggle('Turn together', true, turnTogether),
        toggle('Surface', true, (surface) => show({ surface })),
        toggle('Nodes', true, (nodes) => show({ nodes })),
        element(
            'button',
            { type: 'button', class: 'button button-quiet', click: reset },
            'Reset view',
        ),
    );
}

/**
 * Query and hit side by side, matched branches in one colour, with the table of the matches. The
 * three ways to point at a branch (left picture, right picture, table) do the same.
 */
export function comparison(input: ComparisonInput): Comparison {
    const { query, hit } = input;
    const colors = assignBranchColors(input.match.branches, query.skeleton.branches);
    const linked = new LinkedBranches(input, colors);
    const drawn = hasWebGl();
    if (drawn) {
        linked.addSide({
            role: 'Query',
            model: query,
            pairOf: colors.query,
            branchOf: (pair) => pair.a,
        });
        linked.addSide({ role: 'Hit', model: hit, pairOf: colors.hit, branchOf: (pair) => pair.b });
    }
    const figures = linked.sides.map(({ figure }) => figure);
    return {
        node: dialogContent(
            drawn
                ? [
                      element('div', { class: 'sides' }, figures),
                      controls(linked.sides, linked.orbit),
                  ]
                : noWebGlNotice(),
            element('p', { class: 'match-summary' }, summary(input)),
            input.note,
            linked.table.node,
        ),
        dispose: () => linked.dispose(),
    };
}
