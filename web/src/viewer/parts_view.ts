import '../styles/viewer.css';
import '../styles/parts.css';
import type { UpAxis } from '../api/elements';
import type { Segments, Skeleton } from '../api/types';
import { type Child, element } from '../page/element';
import { formatPlural } from '../page/format';
import { dialogContent } from './dialog_content';
import { partColors } from './part_colors';
import { formatShare, partLegend } from './part_legend';
import type { ScreenPoint } from './pick';
import { noWebGlNotice, type View } from './query_view';
import { loadRig } from './rig';
import { RigPane } from './rig_pane';
import { toggle } from './toggle';
import { hasWebGl } from './webgl';
import { say } from '../words/say';

export interface PartsInput {
    name: string;
    skeleton: Skeleton;
    segments: Segments;
    /** Binary glTF. */
    rig: ArrayBuffer;
    up: UpAxis;
    /** How it stands at first, as onPose told it; empty: as it was made. */
    posed: string;
    /** It was moved. */
    onPose: (posed: string) => void;
    /** Searches for models that have a part. */
    onFind: (part: number) => void;
}

function button(label: string, click: () => void): HTMLButtonElement {
    return element('button', { type: 'button', class: 'button button-quiet', click }, label);
}

/** Undo and redo, by buttons and by the keys that undo everywhere. */
function poseButtons(pane: RigPane): { nodes: HTMLElement[]; show: () => void } {
    const undo = button(say('Undo'), () => pane.undo());
    const redo = button(say('Redo'), () => pane.redo());
    return {
        nodes: [undo, redo, button(say('Reset pose'), () => pane.resetPose())],
        show() {
            undo.disabled = !pane.canUndo;
            redo.disabled = !pane.canRedo;
        },
    };
}

function listenForUndo(node: HTMLElement, pane: RigPane): void {
    node.addEventListener('keydown', (event) => {
        const key = event.key.toLowerCase();
        if (!(event.ctrlKey || event.metaKey) || (key !== 'z' && key !== 'y')) {
            return;
        }
        event.preventDefault();
        if (key === 'y' || event.shiftKey) {
            pane.redo();
        } else {
            pane.undo();
        }
    });
}

function controls(pane: RigPane, poses: readonly HTMLElement[]): HTMLElement {
    const shown = { parts: true, joints: true };
    pane.show(shown);
    return element(
        'div',
        { class: 'viewer-controls', role: 'group', 'aria-label': say('View') },
        toggle(say('Parts'), shown.parts, (on) => {
            shown.parts = on;
            pane.show(shown);
        }),
        toggle(say('Joints'), shown.joints, (on) => {
            shown.joints = on;
            pane.show(shown);
        }),
        element(
            'span',
            { class: 'viewer-buttons' },
            pane.jointCount > 0 && [...poses],
            button(say('Reset view'), () => pane.resetView()),
        ),
    );
}

function advice(joints: number): HTMLElement {
    return element(
        'p',
        { class: 'fine' },
        joints > 0
            ? say(
                  'Drag a joint to move what hangs on it. With the keyboard: Tab to a joint, arrow keys move it, Home puts it back, Ctrl+Z undoes. The address has the pose.',
              )
            : say(
                  'The skeleton of this model has no branch to turn, so that there is nothing to pose.',
              ),
    );
}

/** A model coloured by its parts, with joints to move it by and a legend. */
export async function partsView(input: PartsInput): Promise<View> {
    const { parts } = input.segments;
    const colors = partColors(parts);
    const label = element('span', { class: 'pane-label', hidden: true });
    let pane: RigPane | null = null;
    let poses: ReturnType<typeof poseButtons> | null = null;
    const choose = (part: number | null): void => {
        legend.highlight(part);
        pane?.highlight(part);
    };
    const legend = partLegend({ parts, colors, onChoose: choose, onFind: input.onFind });
    const hovered = (part: number | null, at: ScreenPoint | null): void => {
        choose(part);
        label.hidden = at === null;
        if (at && part !== null) {
            label.style.setProperty('--x', `${at.x}px`);
            label.style.setProperty('--y', `${at.y}px`);
            label.textContent = `${say('Part')} ${part + 1} · ${formatShare(parts[part]?.area_share ?? 0)}`;
        }
    };
    let stage: Child = noWebGlNotice();
    if (hasWebGl()) {
        pane = new RigPane({
            rig: await loadRig(input.rig),
            skeleton: input.skeleton,
            colors,
            label: say('{name} by its parts', { name: input.name }),
            up: input.up,
            onHover: hovered,
            posed: input.posed,
            onPose: (posed) => {
                poses?.show();
                input.onPose(posed);
            },
        });
        pane.node.append(label);
        poses = poseButtons(pane);
        poses.show();
        stage = [element('div', { class: 'side' }, pane.node), controls(pane, poses.nodes)];
    }
    const summary = formatPlural(parts.length, 'part', 'parts');
    const node = dialogContent(
        stage,
        element(
            'p',
            { class: 'match-summary' },
            pane
                ? say('{parts}, {joints} to move.', {
                      parts: summary,
                      joints: formatPlural(pane.jointCount, 'joint', 'joints'),
                  })
                : `${summary}.`,
        ),
        pane && advice(pane.jointCount),
        legend.node,
    );
    if (pane) {
        listenForUndo(node, pane);
    }
    return { node, dispose: () => pane?.dispose() };
}
