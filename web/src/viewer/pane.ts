import { Vector3 } from 'three';

import type { UpAxis } from '../api/elements';
import { ModelScene, type ModelSceneInput } from './model_scene';
import type { OrbitSource } from './orbit_input';
import { nearestLine, type ScreenLine, type ScreenPoint } from './pick';
import { Picture } from './picture';
import { onThemeChange, readViewerTheme } from './theme';
import { toggle } from './toggle';

export interface PaneOptions extends ModelSceneInput {
    /** What a screen reader calls the picture. */
    label: string;
    orbit: OrbitSource;
    up: UpAxis;
    /** The branch under the pointer changed; null: none. */
    onHover: (branch: number | null, at: ScreenPoint | null) => void;
}

const kPickTolerancePixels = 12;

/** A canvas that shows one model with its skeleton. */
export class Pane {
    private readonly picture_: Picture;
    private readonly model_: ModelScene;
    private readonly undo_: (() => void)[] = [];
    private readonly options_: PaneOptions;

    constructor(options: PaneOptions) {
        this.options_ = options;
        this.picture_ = new Picture({
            label: options.label,
            orbit: options.orbit,
            up: options.up,
            beforeDraw: () => {},
        });
        this.model_ = new ModelScene(options, readViewerTheme());
        this.picture_.stand.add(this.model_.root);
        if (this.model_.hasColors) {
            this.picture_.node.append(this.colorControl());
        }
        this.listen();
    }

    get node(): HTMLElement {
        return this.picture_.node;
    }

    /** Takes another orbit: a shared one, or one of its own. */
    follow(orbit: OrbitSource): void {
        this.picture_.follow(orbit);
    }

    get orbit(): OrbitSource {
        return this.picture_.orbit;
    }

    highlight(branch: number | null): void {
        this.model_.highlight(branch);
        this.picture_.requestDraw();
    }

    show(parts: { surface: boolean; nodes: boolean }): void {
        this.model_.surfaceVisible = parts.surface;
        this.model_.nodesVisible = parts.nodes;
        this.picture_.requestDraw();
    }

    dispose(): void {
        for (const undo of this.undo_) {
            undo();
        }
        this.model_.dispose();
        this.picture_.dispose();
    }

    private colorControl(): HTMLElement {
        const control = toggle('Colours of the file', true, (colored) => {
            this.model_.colored = colored;
            this.picture_.requestDraw();
        });
        control.classList.add('color-control');
        return control;
    }

    private listen(): void {
        const { canvas } = this.picture_;
        const undo = new AbortController();
        const { signal } = undo;
        canvas.addEventListener('pointermove', (event) => this.hover(event), { signal });
        canvas.addEventListener('pointerleave', () => this.options_.onHover(null, null), {
            signal,
        });
        this.undo_.push(
            () => undo.abort(),
            onThemeChange(() => {
                this.model_.applyTheme(readViewerTheme());
                this.picture_.requestDraw();
            }),
        );
    }

    private hover(event: PointerEvent): void {
        if (event.buttons !== 0) {
            return;
        }
        const at = this.picture_.pointOf(event);
        const branch = nearestLine(this.projectedBranches(), at, kPickTolerancePixels);
        this.options_.onHover(branch, branch === null ? null : at);
    }

    private projectedBranches(): ScreenLine[] {
        return this.model_.branchLines.map(({ id, points }) => ({
            id,
            points: points.map((point) =>
                this.picture_.project(this.model_.root.localToWorld(new Vector3(...point))),
            ),
        }));
    }
}
