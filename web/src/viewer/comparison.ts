import '../styles/viewer.css';
import '../styles/look.css';
import type { SkeletonBranch } from '../api/elements';
import type { Match } from '../api/types';
import { element } from '../page/element';
import { formatDistance, formatPlural, formatSize } from '../page/format';
import { say } from '../words/say';
import { assignBranchColors, type BranchColors, type ColoredPair } from './branch_colors';
import { dialogContent } from './dialog_content';
import { lookControls } from './look_controls';
import { type MatchTable, matchTable } from './match_table';
import { OrbitSource } from './orbit_input';
import { OverlaySwitch } from './overlay';
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
    /** Searches for models that have a branch of the query. */
    onFind: (branch: SkeletonBranch) => void;
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
    const nodes = formatPlural(input.match.nodes.length, 'node', 'nodes');
    const branches = formatPlural(input.match.branches.length, 'branch', 'branches');
    return clusters.length > 1
        ? say('{branches} and {nodes} match, in {groups} groups of {sizes} nodes.', {
              branches,
              nodes,
              groups: clusters.length,
              sizes: clusters.join(', '),
          })
        : say('{branches} and {nodes} match.', { branches, nodes });
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
            onFind: ({ a }) => {
                const branch = input.query.skeleton.branches.find(({ id }) => id === a);
                if (branch) {
                    input.onFind(branch);
                }
            },
        });
    }

    addSide(options: SideOptions): void {
        const { role, model, pairOf } = options;
        const label = element('span', { class: 'pane-label', hidden: true });
        const pane = new Pane({
            mesh: model.mesh,
            skeleton: model.skeleton,
            branchColors: new Map([...pairOf].map(([id, pair]) => [id, pair.color])),
            label: `${role}: ${say('{name} with its skeleton', { name: model.name })}`,
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
                ? `${say('Branch')} ${pair.number} · ${say('Cost')} ${formatDistance(pair.cost)}`
                : say('No counterpart');
        }
    }
}

/** Whether both turn with one hand. */
function turnSwitch(sides: readonly Side[], shared: OrbitSource): HTMLElement {
    return toggle(say('Turn together'), true, (together) => {
        const { orbit } = sides[0]?.pane.orbit ?? shared;
        shared.set(orbit);
        for (const { pane } of sides) {
            pane.follow(together ? shared : new OrbitSource(orbit));
        }
    });
}

function stageOf(
    input: ComparisonInput,
    linked: LinkedBranches,
): { nodes: HTMLElement[]; end: () => void } {
    const { query, hit, match } = input;
    const sides = element(
        'div',
        { class: 'sides' },
        linked.sides.map(({ figure }) => figure),
    );
    const over =
        query.mesh && hit.mesh
            ? new OverlaySwitch({ query, hit, match, orbit: linked.orbit }, sides)
            : null;
    const controls = lookControls({
        panes: linked.sides.map(({ pane, model: { name, unit } }) => ({ pane, name, unit })),
        stage: sides,
        more: [turnSwitch(linked.sides, linked.orbit), ...(over ? [over.control] : [])],
    });
    return { nodes: [sides, controls], end: () => over?.dispose() };
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
            role: say('Query'),
            model: query,
            pairOf: colors.query,
            branchOf: (pair) => pair.a,
        });
        linked.addSide({
            role: say('Hit'),
            model: hit,
            pairOf: colors.hit,
            branchOf: (pair) => pair.b,
        });
    }
    const stage = drawn ? stageOf(input, linked) : null;
    return {
        node: dialogContent(
            stage?.nodes ?? noWebGlNotice(),
            element('p', { class: 'match-summary' }, summary(input)),
            input.note,
            linked.table.node,
        ),
        dispose() {
            stage?.end();
            linked.dispose();
        },
    };
}
