import {
    AmbientLight,
    DirectionalLight,
    PerspectiveCamera,
    Scene,
    Vector3,
    WebGLRenderer,
} from 'three';

import { element } from '../page/element';
import { ModelScene, type ModelSceneInput } from './model_scene';
import { cameraPosition } from './orbit';
import { nearestLine, type ScreenLine, type ScreenPoint } from './pick';
import { attachOrbitInput, type OrbitSource } from './orbit_input';
import { onThemeChange, readViewerTheme } from './theme';

export interface PaneOptions extends ModelSceneInput {
    /** What a screen reader calls the picture. */
    label: string;
    orbit: OrbitSource;
    /** The branch under the pointer changed; null: none. */
    onHover: (branch: number | null, at: ScreenPoint | null) => void;
}

const kFieldOfViewDegrees = 38;
const kMostPixelRatio = 2;
const kPickTolerancePixels = 12;

/**
 * A canvas that shows one model. It draws when something changed and not otherwise, and gives its
 * graphics memory and context back in {@link dispose}.
 */
export class Pane {
    readonly node: HTMLElement;
    private readonly canvas_: HTMLCanvasElement;
    private readonly renderer_: WebGLRenderer;
    private readonly scene_ = new Scene();
    private readonly camera_ = new PerspectiveCamera(kFieldOfViewDegrees, 1, 0.05, 40);
    private readonly model_: ModelScene;
    private readonly undo_: (() => void)[] = [];
    private readonly options_: PaneOptions;
    private orbit_: OrbitSource;
    private unsubscribe_: () => void = () => {};
    private frame_ = 0;

    constructor(options: PaneOptions) {
        this.options_ = options;
        this.orbit_ = options.orbit;
        this.canvas_ = element('canvas', {
            class: 'pane-canvas',
            tabindex: 0,
            role: 'img',
            'aria-label': `${options.label}. Arrow keys turn it, plus and minus zoom.`,
        });
        this.node = element('div', { class: 'pane' }, this.canvas_);
        this.renderer_ = new WebGLRenderer({ canvas: this.canvas_, antialias: true, alpha: true });
        this.renderer_.setPixelRatio(Math.min(devicePixelRatio, kMostPixelRatio));
        this.model_ = new ModelScene(options, readViewerTheme());
        this.addLights();
        this.scene_.add(this.model_.root, this.camera_);
        this.listen();
        this.follow(options.orbit);
    }

    /** Takes another orbit: a shared one, or one of its own. */
    follow(orbit: OrbitSource): void {
        this.unsubscribe_();
        this.orbit_ = orbit;
        this.unsubscribe_ = orbit.subscribe(() => this.requestDraw());
        this.requestDraw();
    }

    get orbit(): OrbitSource {
        return this.orbit_;
    }

    highlight(branch: number | null): void {
        this.model_.highlight(branch);
        this.requestDraw();
    }

    show(parts: { surface: boolean; nodes: boolean }): void {
        this.model_.surfaceVisible = parts.surface;
        this.model_.nodesVisible = parts.nodes;
        this.requestDraw();
    }

    dispose(): void {
        cancelAnimationFrame(this.frame_);
        this.unsubscribe_();
        for (const undo of this.undo_) {
            undo();
        }
        this.model_.dispose();
        this.renderer_.dispose();
        this.renderer_.forceContextLoss();
        this.node.remove();
    }

    private addLights(): void {
        const key = new DirectionalLight('#ffffff', 2.2);
        key.position.set(0.6, 1, 0.8);
        // On the camera: whatever side is looked at is lit.
        this.camera_.add(key);
        this.scene_.add(new AmbientLight('#ffffff', 1.1));
    }

    private listen(): void {
        const resized = new ResizeObserver(() => this.resize());
        resized.observe(this.node);
        const hover = (event: PointerEvent): void => this.hover(event);
        const leave = (): void => this.options_.onHover(null, null);
        this.canvas_.addEventListener('pointermove', hover);
        this.canvas_.addEventListener('pointerleave', leave);
        this.undo_.push(
            () => resized.disconnect(),
            () => this.canvas_.removeEventListener('pointermove', hover),
            () => this.canvas_.removeEventListener('pointerleave', leave),
            attachOrbitInput(this.canvas_, () => this.orbit_),
            onThemeChange(() => {
                this.model_.applyTheme(readViewerTheme());
                this.requestDraw();
            }),
        );
    }

    private resize(): void {
        const { clientWidth, clientHeight } = this.node;
        if (clientWidth > 0 && clientHeight > 0) {
            this.renderer_.setSize(clientWidth, clientHeight, false);
            this.camera_.aspect = clientWidth / clientHeight;
            this.draw();
        }
    }

    private hover(event: PointerEvent): void {
        if (event.buttons !== 0) {
            return;
        }
        const box = this.canvas_.getBoundingClientRect();
        const at = { x: event.clientX - box.left, y: event.clientY - box.top };
        const branch = nearestLine(this.projectedBranches(box), at, kPickTolerancePixels);
        this.options_.onHover(branch, branch === null ? null : at);
    }

    private projectedBranches(box: { width: number; height: number }): ScreenLine[] {
        return this.model_.branchLines.map(({ id, points }) => ({
            id,
            points: points.map((point) => {
                const seen = new Vector3(...point).project(this.camera_);
                return { x: ((seen.x + 1) / 2) * box.width, y: ((1 - seen.y) / 2) * box.height };
            }),
        }));
    }

    private requestDraw(): void {
        if (this.frame_ === 0) {
            this.frame_ = requestAnimationFrame(() => this.draw());
        }
    }

    private draw(): void {
        cancelAnimationFrame(this.frame_);
        this.frame_ = 0;
        // A pane narrower than high has to stand further back to show the whole sphere.
        const orbit = this.orbit_.orbit;
        const narrow = Math.max(1, 1 / this.camera_.aspect);
        this.camera_.position.set(
            ...cameraPosition({ ...orbit, distance: orbit.distance * narrow }),
        );
        this.camera_.lookAt(0, 0, 0);
        this.camera_.updateProjectionMatrix();
        this.renderer_.render(this.scene_, this.camera_);
    }
}
