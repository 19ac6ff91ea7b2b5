import { Raycaster, Vector2, Vector3 } from 'three';

import type { UpAxis } from '../api/elements';
import type { Skeleton } from '../api/types';
import { JointHandles } from './joint_handles';
import { kFirstOrbit } from './orbit';
import { OrbitSource } from './orbit_input';
import type { ScreenPoint } from './pick';
import { Picture } from './picture';
import { findHandles, type Handle, Pose, positionOf, reach } from './pose';
import type { Rig } from './rig';
import { RigScene } from './rig_scene';
import { onThemeChange, readViewerTheme } from './theme';

export interface RigPaneOptions {
    rig: Rig;
    skeleton: Skeleton;
    /** `#rrggbb` by the number of the part. */
    colors: readonly string[];
    up: UpAxis;
    /** What a screen reader calls the picture. */
    label: string;
    /** The part under the pointer changed; null: none. */
    onHover: (part: number | null, at: ScreenPoint | null) => void;
    /** How it stands at first, see Pose; empty: as it was made. */
    posed: string;
    /** It stands otherwise, or something else can be taken back. */
    onPose: (posed: string) => void;
}

const kRadiansPerStep = Math.PI / 36;

/** A canvas that shows a model by its parts, with joints to move it by. */
export class RigPane {
    private readonly picture_: Picture;
    private readonly model_: RigScene;
    private readonly pose_: Pose;
    private readonly joints_: JointHandles;
    private readonly undo_: (() => void)[] = [];
    private readonly onPose_: (posed: string) => void;
    readonly jointCount: number;

    constructor(options: RigPaneOptions) {
        const handles = findHandles(options.rig.bones);
        this.jointCount = handles.length;
        this.picture_ = new Picture({
            label: options.label,
            orbit: new OrbitSource(),
            up: options.up,
            beforeDraw: () => this.joints_.place(),
        });
        this.model_ = new RigScene(options, readViewerTheme());
        this.onPose_ = options.onPose;
        this.pose_ = new Pose(options.rig.bones);
        this.pose_.text = options.posed;
        this.picture_.stand.add(this.model_.root);
        this.joints_ = new JointHandles({
            handles,
            locate: (handle) => this.picture_.project(positionOf(handle.end)),
            pointOf: (event) => this.picture_.pointOf(event),
            onDrag: (handle, to) => this.drag(handle, to),
            onStep: (handle, right, up) => this.step(handle, right, up),
            onReset: (handle) => {
                this.pose_.reset([handle.pivot]);
                this.moved();
            },
            onDone: () => this.done(),
        });
        this.picture_.node.append(this.joints_.node);
        this.listen(options);
        this.moved();
    }

    get node(): HTMLElement {
        return this.picture_.node;
    }

    show(what: { parts: boolean; joints: boolean }): void {
        this.model_.colored = what.parts;
        this.model_.skeletonVisible = what.joints;
        this.joints_.visible = what.joints;
        this.picture_.requestDraw();
    }

    highlight(part: number | null): void {
        this.model_.highlight(part);
        this.picture_.requestDraw();
    }

    resetPose(): void {
        this.pose_.reset();
        this.moved();
        this.done();
    }

    get canUndo(): boolean {
        return this.pose_.canUndo;
    }

    get canRedo(): boolean {
        return this.pose_.canRedo;
    }

    undo(): void {
        this.pose_.undo();
        this.moved();
        this.onPose_(this.pose_.text);
    }

    redo(): void {
        this.pose_.redo();
        this.moved();
        this.onPose_(this.pose_.text);
    }

    resetView(): void {
        this.picture_.orbit.set({ ...kFirstOrbit });
    }

    dispose(): void {
        for (const undo of this.undo_) {
            undo();
        }
        this.model_.dispose();
        this.picture_.dispose();
    }

    private drag(handle: Handle, to: ScreenPoint): void {
        const ray = {
            origin: this.picture_.camera.position,
            direction: this.picture_.direction(to),
        };
        const target = reach(ray, positionOf(handle.pivot), positionOf(handle.end));
        this.pose_.swing(handle, target);
        this.moved();
    }

    private step(handle: Handle, right: number, up: number): void {
        const end = positionOf(handle.end);
        const length = end.distanceTo(positionOf(handle.pivot));
        const move = new Vector3(right, up, 0).applyQuaternion(this.picture_.camera.quaternion);
        this.pose_.swing(handle, end.addScaledVector(move, length * Math.tan(kRadiansPerStep)));
        this.moved();
    }

    private done(): void {
        if (this.pose_.commit()) {
            this.onPose_(this.pose_.text);
        }
    }

    private moved(): void {
        this.model_.moved();
        this.picture_.requestDraw();
    }

    private listen(options: RigPaneOptions): void {
        const { canvas } = this.picture_;
        const undo = new AbortController();
        const { signal } = undo;
        const hover = (event: PointerEvent): void => {
            if (event.buttons === 0) {
                const at = this.picture_.pointOf(event);
                const part = this.partAt(at);
                options.onHover(part, part === null ? null : at);
            }
        };
        canvas.addEventListener('pointermove', hover, { signal });
        canvas.addEventListener('pointerleave', () => options.onHover(null, null), { signal });
        this.undo_.push(
            () => undo.abort(),
            onThemeChange(() => {
                this.model_.applyTheme(readViewerTheme());
                this.picture_.requestDraw();
            }),
        );
    }

    private partAt(at: ScreenPoint): number | null {
        const { clientWidth, clientHeight } = this.picture_.canvas;
        const ray = new Raycaster();
        ray.setFromCamera(
            new Vector2((2 * at.x) / clientWidth - 1, 1 - (2 * at.y) / clientHeight),
            this.picture_.camera,
        );
        return this.model_.partAt(ray);
    }
}
