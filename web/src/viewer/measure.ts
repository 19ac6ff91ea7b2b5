import {
    BufferGeometry,
    Group,
    LineBasicMaterial,
    LineSegments,
    Mesh,
    MeshBasicMaterial,
    SphereGeometry,
    type Vector3,
} from 'three';

import { disposeBelow } from './dispose';

const kDotRadius = 0.018;

/** Two points and the line between them, over everything else. */
export class Measure {
    readonly root = new Group();
    private points_: Vector3[] = [];
    private readonly color_: string;

    constructor(color: string) {
        this.color_ = color;
    }

    /** The third point begins anew. */
    add(point: Vector3): void {
        this.points_ = this.points_.length >= 2 ? [point] : [...this.points_, point];
        this.show();
    }

    clear(): void {
        this.points_ = [];
        this.show();
    }

    /** Between both points, in the frame of `root`; null before there are two. */
    get length(): number | null {
        const [first, second] = this.points_;
        return first && second ? first.distanceTo(second) : null;
    }

    get count(): number {
        return this.points_.length;
    }

    dispose(): void {
        disposeBelow(this.root);
    }

    private show(): void {
        disposeBelow(this.root);
        for (const point of this.points_) {
            const dot = new Mesh(
                new SphereGeometry(kDotRadius, 16, 12),
                new MeshBasicMaterial({ color: this.color_, depthTest: false, transparent: true }),
            );
            dot.position.copy(point);
            dot.renderOrder = 8;
            this.root.add(dot);
        }
        if (this.points_.length === 2) {
            const line = new LineSegments(
                new BufferGeometry().setFromPoints(this.points_),
                new LineBasicMaterial({ color: this.color_, depthTest: false, transparent: true }),
            );
            line.renderOrder = 8;
            this.root.add(line);
        }
    }
}
