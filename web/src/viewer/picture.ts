import {
    AmbientLight,
    DirectionalLight,
    OrthographicCamera,
    PerspectiveCamera,
    Scene,
    Vector3,
    WebGLRenderer,
} from 'three';

import type { UpAxis } from '../api/elements';
import { element } from '../page/element';
import { cameraPosition } from './orbit';
import { attachOrbitInput, type OrbitSource } from './orbit_input';
import type { ScreenPoint } from './pick';
import { Stand, upControl } from './up_axis';
import { say } from '../words/say';

export interface PictureOptions {
    /** What a screen reader calls the picture. */
    label: string;
    orbit: OrbitSource;
    /** The axis of the model's file that points up, until the viewer wants another. */
    up: UpAxis;
    /** The camera stands where the picture is about to be taken from. */
    beforeDraw: () => void;
    /** Whether it can be taken by pointer and keyboard, and turned upright; without, it is but looked at. */
    controls?: boolean;
}

const kFieldOfViewDegrees = 38;
const kMostPixelRatio = 2;

/**
 * A canvas with a lit model in the unit sphere. It draws when something changed and not otherwise,
 * and gives its graphics memory and context back in {@link dispose}. The canvas says by
 * `data-picture` whether it shows what was asked for last: `pending` until then, `drawn` from then on.
 */
export class Picture {
    readonly node: HTMLElement;
    readonly canvas: HTMLCanvasElement;
    /** What is shown stands here. */
    readonly stand = new Stand();
    private readonly perspective_ = new PerspectiveCamera(kFieldOfViewDegrees, 1, 0.05, 40);
    private readonly parallel_ = new OrthographicCamera(-1, 1, 1, -1, 0.05, 40);
    private isParallel_ = false;
    private readonly scene_ = new Scene();
    private readonly renderer_: WebGLRenderer;
    private readonly undo_: (() => void)[] = [];
    private readonly beforeDraw_: () => void;
    private orbit_: OrbitSource;
    private unsubscribe_: () => void = () => {};
    private frame_ = 0;
    /** False until the page has given the canvas its place: there is nothing to draw on before. */
    private sized_ = false;

    constructor(options: PictureOptions) {
        this.orbit_ = options.orbit;
        this.beforeDraw_ = options.beforeDraw;
        this.canvas = element('canvas', {
            class: 'pane-canvas',
            tabindex: options.controls === false ? null : 0,
            role: 'img',
            'aria-label': `${options.label}. ${say('Arrow keys turn it, plus and minus zoom.')}`,
        });
        this.stand.upAxis = options.up;
        const up = upControl(options.up, (axis) => {
            this.stand.upAxis = axis;
            this.requestDraw();
        });
        const { controls = true } = options;
        this.node = element('div', { class: 'pane' }, this.canvas, controls && up);
        this.renderer_ = new WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
        this.renderer_.setPixelRatio(Math.min(devicePixelRatio, kMostPixelRatio));
        this.addLights();
        // What is cut away is told by the materials.
        this.renderer_.localClippingEnabled = true;
        this.scene_.add(this.stand, this.perspective_, this.parallel_);
        const resized = new ResizeObserver(() => this.resize());
        resized.observe(this.node);
        this.undo_.push(() => resized.disconnect());
        if (controls) {
            this.undo_.push(attachOrbitInput(this.canvas, () => this.orbit_));
        }
        this.follow(options.orbit);
    }

    /** Takes another orbit: a shared one, or one of its own. */
    follow(orbit: OrbitSource): void {
        this.unsubscribe_();
        this.orbit_ = orbit;
        this.unsubscribe_ = orbit.subscribe(() => this.requestDraw());
        this.requestDraw();
    }

    get camera(): PerspectiveCamera | OrthographicCamera {
        return this.isParallel_ ? this.parallel_ : this.perspective_;
    }

    /** Without perspective: parallel edges stay parallel. */
    set orthographic(on: boolean) {
        this.isParallel_ = on;
        this.requestDraw();
    }

    /** What is seen, as a PNG file without ground; null where the browser cannot make one. */
    snapshot(): Promise<Blob | null> {
        // The drawing is gone once the browser has shown it.
        this.draw();
        return new Promise((resolve) => this.canvas.toBlob(resolve));
    }

    get orbit(): OrbitSource {
        return this.orbit_;
    }

    requestDraw(): void {
        this.canvas.dataset.picture = 'pending';
        if (this.frame_ === 0) {
            this.frame_ = requestAnimationFrame(() => this.draw());
        }
    }

    /** Where an event happened, in pixels from the canvas' corner. */
    pointOf(event: { clientX: number; clientY: number }): ScreenPoint {
        const box = this.canvas.getBoundingClientRect();
        return { x: event.clientX - box.left, y: event.clientY - box.top };
    }

    /** Where a point of the scene is seen; `depth` grows from -1 (near) to 1. */
    project(point: Vector3): ScreenPoint & { depth: number } {
        const { clientWidth, clientHeight } = this.canvas;
        const seen = point.clone().project(this.camera);
        return {
            x: ((seen.x + 1) / 2) * clientWidth,
            y: ((1 - seen.y) / 2) * clientHeight,
            depth: seen.z,
        };
    }

    /** The direction from the camera through a pixel. */
    direction(at: ScreenPoint): Vector3 {
        const { clientWidth, clientHeight } = this.canvas;
        const x = (2 * at.x) / Math.max(1, clientWidth) - 1;
        const y = 1 - (2 * at.y) / Math.max(1, clientHeight);
        return new Vector3(x, y, 0.5).unproject(this.camera).sub(this.camera.position).normalize();
    }

    dispose(): void {
        cancelAnimationFrame(this.frame_);
        this.unsubscribe_();
        for (const undo of this.undo_) {
            undo();
        }
        this.renderer_.dispose();
        this.renderer_.forceContextLoss();
        this.node.remove();
    }

    private addLights(): void {
        // On the cameras: whatever side is looked at is lit.
        for (const camera of [this.perspective_, this.parallel_]) {
            const key = new DirectionalLight('#ffffff', 2.2);
            key.position.set(0.6, 1, 0.8);
            camera.add(key);
            camera.add(key.target);
        }
        this.scene_.add(new AmbientLight('#ffffff', 1.1));
    }

    private resize(): void {
        const { clientWidth, clientHeight } = this.node;
        if (clientWidth > 0 && clientHeight > 0) {
            this.renderer_.setSize(clientWidth, clientHeight, false);
            this.perspective_.aspect = clientWidth / clientHeight;
            this.sized_ = true;
            this.draw();
        }
    }

    private draw(): void {
        cancelAnimationFrame(this.frame_);
        this.frame_ = 0;
        if (!this.sized_) {
            return;
        }
        // A picture narrower than high has to be taken from further back to show the whole sphere.
        const orbit = this.orbit_.orbit;
        const { aspect } = this.perspective_;
        const distance = orbit.distance * Math.max(1, 1 / aspect);
        const { camera } = this;
        camera.position.set(...cameraPosition({ ...orbit, distance }));
        camera.lookAt(0, 0, 0);
        // As large as perspective shows what lies in the middle.
        const half = distance * Math.tan((kFieldOfViewDegrees * Math.PI) / 360);
        Object.assign(this.parallel_, {
            left: -half * aspect,
            right: half * aspect,
            top: half,
            bottom: -half,
        });
        camera.updateProjectionMatrix();
        camera.updateMatrixWorld(true);
        this.beforeDraw_();
        this.renderer_.render(this.scene_, camera);
        this.canvas.dataset.picture = 'drawn';
    }
}
