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

function* vertices(mesh: PreviewMesh): Generator<Point> {
    const { positions } = mesh;
    for (let at = 0; at + 2 < positions.length; at += 3) {
        yield [positions[at] ?? 0, positions[at + 1] ?? 0, positions[at + 2] ?? 0];
    }
}

/**
 * The smallest sphere around the middle of the bounding box. A point, or nothing at all, is framed
 * without scaling, so that no infinity gets further.
 */
export function frameOf(points: readonly Point[]): Frame {
    const bounds = boundsOf(points);
    if (!bounds) {
        return { center: [0, 0, 0], scale: 1 };
    }
    const { min, max } = bounds;
    const center: Point = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2];
    let radius = 0;
    for (const [x, y, z] of points) {
        radius = Math.max(radius, Math.hypot(x - center[0], y - center[1], z - center[2]));
    }
    return { center, scale: radius > 0 && Number.isFinite(1 / radius) ? 1 / radius : 1 };
}

/** The mesh decides where there is one; a skeleton alone is framed by its own points. */
export function frameModel(mesh: PreviewMesh | null, skeleton: Skeleton): Frame {
    if (mesh && mesh.triangles.length > 0) {
        return frameOf([...vertices(mesh)]);
    }
    const lines = skeleton.branches.flatMap((branch) => branch.points);
    return frameOf([...lines, ...skeleton.nodes.map((node) => node.position)]);
}
