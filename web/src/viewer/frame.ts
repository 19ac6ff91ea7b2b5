import type { Bounds, Point, PreviewMesh, Skeleton } from '../api/types';

/** Takes a model to the unit sphere around the origin: (p - center) * scale. */
export interface Frame {
    center: Point;
    scale: number;
}

export function boundsOf(points: Iterable<Point>): Bounds | null {
    const bounds: Bounds = {
        min: [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY],
        max: [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY],
    };
    for (const point of points) {
        for (const axis of [0, 1, 2] as const) {
            bounds.min[axis] = Math.min(bounds.min[axis], point[axis]);
            bounds.max[axis] = Math.max(bounds.max[axis], point[axis]);
        }
    }
    return Number.isFinite(bounds.min[0]) ? bounds : null;
}

/** A point or nothing at all is framed without scaling, so that no infinity gets further. */
export function frameOf(bounds: Bounds | null): Frame {
    if (!bounds) {
        return { center: [0, 0, 0], scale: 1 };
    }
    const size = bounds.max.map((high, axis) => high - (bounds.min[axis] ?? 0));
    const radius = Math.hypot(...size) / 2;
    return {
        center: bounds.max.map((high, axis) => (high + (bounds.min[axis] ?? 0)) / 2) as Point,
        scale: radius > 0 && Number.isFinite(radius) ? 1 / radius : 1,
    };
}

/** The mesh decides where there is one; a skeleton alone is framed by its own points. */
export function frameModel(mesh: PreviewMesh | null, skeleton: Skeleton): Frame {
    if (mesh && mesh.triangles.length > 0) {
        return frameOf(mesh.bounds);
    }
    const lines = skeleton.branches.flatMap((branch) => branch.points);
    return frameOf(boundsOf([...lines, ...skeleton.nodes.map((node) => node.position)]));
}
