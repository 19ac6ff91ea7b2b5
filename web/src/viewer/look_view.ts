import '../styles/viewer.css';
import '../styles/look.css';
import type { SkeletonBranch } from '../api/elements';
import { element } from '../page/element';
import { formatLength } from '../page/format';
import { say } from '../words/say';
import { branchTable } from './branch_table';
import { dialogContent } from './dialog_content';
import { lookControls } from './look_controls';
import { OrbitSource } from './orbit_input';
import { Pane } from './pane';
import type { ScreenPoint } from './pick';
import { noWebGlNotice, type View, type ViewedModel } from './query_view';
import { readAccent } from './theme';
import { hasWebGl } from './webgl';

export interface LookInput {
    model: ViewedModel;
    /** Beside the picture, above the branches. */
    about: HTMLElement | null;
    /** Searches for models that have a branch; null: the page cannot. */
    onFind: ((branch: SkeletonBranch) => void) | null;
}

/** One model, as large as there is room, and what its branches are. */
export function lookView({ model, about, onFind }: LookInput): View {
    const { name, mesh, skeleton, up, unit } = model;
    const label = element('span', { class: 'pane-label', hidden: true });
    let pane: Pane | null = null;
    const choose = (branch: number | null): void => {
        table.highlight(branch);
        pane?.highlight(branch);
    };
    const table = branchTable({ skeleton, unit, onChoose: choose, onFind });
    const hovered = (id: number | null, at: ScreenPoint | null): void => {
        choose(id);
        const branch = skeleton.branches.find((each) => each.id === id);
        label.hidden = at === null || !branch;
        if (at && branch) {
            label.style.setProperty('--x', `${at.x}px`);
            label.style.setProperty('--y', `${at.y}px`);
            label.textContent = `${formatLength(branch.length, unit)} · ${branch.chain_code}`;
        }
    };
    if (!hasWebGl()) {
        return {
            node: dialogContent(noWebGlNotice(), about, table.node),
            dispose: () => {},
        };
    }
    const accent = readAccent();
    const shown = new Pane({
        mesh,
        skeleton,
        branchColors: new Map(skeleton.branches.map((branch) => [branch.id, accent])),
        label: say('{name} with its skeleton', { name }),
        orbit: new OrbitSource(),
        up,
        onHover: hovered,
    });
    pane = shown;
    shown.node.append(label);
    const stage = element('div', { class: 'side' }, shown.node);
    const controls = lookControls({ panes: [{ pane: shown, name, unit }], stage, more: [] });
    return {
        node: dialogContent([stage, controls], about, table.node),
        dispose: () => shown.dispose(),
    };
}
