import { Plane, Raycaster, Vector2, Vector3 } from 'three';

import type { UpAxis } from '../api/elements';
import { Measure } from './measure';
import { ModelScene, type ModelSceneInput } from './model_scene';
import type { OrbitSource } from './orbit_input';
import { nearestLine, type ScreenLine, type ScreenPoint } from './pick';
import { Picture } from './picture';
import { onThemeChange, readViewerTheme } from './theme';
import { toggle } from './toggle';
import { say } from '../words/say';

export interface PaneOptions extends ModelSceneInput {
    /** What a screen reader calls the picture. */
    label: string;
    orbit: OrbitSource;
    up: UpAxis;
    /** The branch under the pointer changed; null: none. */
    onHover: (branch: number | null, at: ScreenPoint | null) => void;
}

/** How a model is drawn; what is left out stays as it is. */
export interface PaneLook {
    surface: boolean;
    nodes: boolean;
    /** From 0 to 1; null: as the page's style has it. */
    opacity: number | null;
    wireframe: boolean;
    /** The box along the axes of the file. */
    box: boolean;
    orthographic: boolean;
    section: Section | null;
}

/** What of a model is cut away: all that lies further along an axis of its file than a share of it. */
export interface Section {
    axis: 0 | 1 | 2;
    /** From -1 to 1, in radii of the model from its middle. */
    at: number;
}

const kPickTolerancePixels = 12;
/** A press that moves further is one that turns the model. */
const kStillPixels = 4;

/** A canvas that shows one model with its skeleton. */
export class Pane {
    private readonly picture_: Picture;
    private readonly model_: ModelScene;
    private readonly undo_: (() => void)[] = [];
    private readonly options_: PaneOptions;
    private readonly measure_ = new Measure(readViewerTheme().measure);
    /** Told the length once there is one, in the model's unit; null: not yet. */
    private onMeasure_: ((length: number | null) => void) | null = null;

    constructor(options: PaneOptions) {
        this.options_ = options;
        this.picture_ = new Picture({
            label: options.label,
            orbit: options.orbit,
            up: options.up,
            beforeDraw: () => {},
        });
        this.model_ = new ModelScene(options, readViewerTheme());
        this.model_.root.add(this.measure_.root);
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

    show(look: Partial<PaneLook>): void {
        const { surface, nodes, opacity, wireframe, box, orthographic, section } = look;
        const set = <T>(value: T | undefined, take: (value: T) => void): void => {
            if (value !== undefined) {
                take(value);
            }
        };
        set(surface, (on) => {
            this.model_.surfaceVisible = on;
        });
        set(nodes, (on) => {
            this.model_.nodesVisible = on;
        });
        set(opacity, (share) => {
            this.model_.opacity = share;
        });
        set(wireframe, (on) => {
            this.model_.wireframe = on;
        });
        set(box, (on) => {
            this.model_.boxed = on;
        });
        set(orthographic, (on) => {
            this.picture_.orthographic = on;
        });
        set(section, (cut) => this.cut(cut));
        this.picture_.requestDraw();
    }

    /** From now on presses on the surface are ends of a length; null ends it. */
    measure(onMeasure: ((length: number | null) => void) | null): void {
        this.onMeasure_ = onMeasure;
        this.measure_.clear();
        this.picture_.canvas.classList.toggle('measuring', onMeasure !== null);
        this.picture_.requestDraw();
    }

    /** What is seen, as a PNG file; null where the browser cannot make one. */
    snapshot(): Promise<Blob | null> {
        return this.picture_.snapshot();
    }

    get model(): ModelScene {
        return this.model_;
    }

    dispose(): void {
        for (const undo of this.undo_) {
            undo();
        }
        this.measure_.dispose();
        this.model_.dispose();
        this.picture_.dispose();
    }

    private colorControl(): HTMLElement {
        const control = toggle(say('Colours of the file'), true, (colored) => {
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
        let pressed: ScreenPoint | null = null;
        canvas.addEventListener(
            'pointerdown',
            (event) => {
                pressed = this.picture_.pointOf(event);
            },
            { signal },
        );
        canvas.addEventListener(
            'click',
            (event) => {
                const at = this.picture_.pointOf(event);
                if (pressed && Math.hypot(at.x - pressed.x, at.y - pressed.y) <= kStillPixels) {
                    this.measureAt(at);
                }
            },
            { signal },
        );
        canvas.addEventListener(
            'keydown',
            (event) => {
                if (event.key === 'Enter') {
                    const { clientWidth, clientHeight } = canvas;
                    this.measureAt({ x: clientWidth / 2, y: clientHeight / 2 });
                }
            },
            { signal },
        );
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

    private cut(section: Section | null): void {
        if (!section) {
            this.model_.section = null;
            return;
        }
        const normal = new Vector3().setComponent(section.axis, -1);
        normal.transformDirection(this.picture_.stand.matrixWorld);
        this.model_.section = new Plane(normal, section.at);
    }

    private measureAt(at: ScreenPoint): void {
        if (!this.onMeasure_) {
            return;
        }
        const { clientWidth, clientHeight } = this.picture_.canvas;
        const ray = new Raycaster();
        ray.setFromCamera(
            new Vector2((2 * at.x) / clientWidth - 1, 1 - (2 * at.y) / clientHeight),
            this.picture_.camera,
        );
        const point = this.model_.surfacePoint(ray);
        if (point) {
            this.measure_.add(point);
            const { length } = this.measure_;
            this.onMeasure_(length === null ? null : length * this.model_.unitLength);
            this.picture_.requestDraw();
        }
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
