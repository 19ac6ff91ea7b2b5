import type { PreviewMesh } from '../api/elements';
import type { Bounds, Skeleton, Vector } from '../api/types';

/** Takes a model to the unit sphere around the origin: (p - center) * scale. */
export interface Frame {
    /** In the file's frame. */
    center: Vector;
    scale: number;
}

const kFileOrigin: Readonly<Vector> = [0, 0, 0];

/**
 * Where a point lies in the unit sphere; `origin` is what the point is counted from. To be called before
 * numbers become those of a vertex buffer, whose seven places are not enough far from the origin.
 */
export function toUnit(
    frame: Frame,
    point: Vector,
    origin: Readonly<Vector> = kFileOrigin,
): Vector {
    const { center, scale } = frame;
    return [
        (origin[0] - center[0] + point[0]) * scale,
        (origin[1] - center[1] + point[1]) * scale,
        (origin[2] - center[2] + point[2]) * scale,
    ];
}

/** The vertices of a mesh in the unit sphere, three numbers each. */
export function unitPositions(frame: Frame, mesh: PreviewMesh): Float32Array {
    const unit = new Float32Array(mesh.positions.length);
    let at = 0;
    for (const vertex of vertices(mesh)) {
        unit.set(toUnit(frame, vertex, mesh.origin), at);
        at += 3;
    }
    return unit;
}

export function boundsOf(points: Iterable<Vector>): Bounds | null {
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

function* vertices(mesh: PreviewMesh): Generator<Vector> {
    const { positions } = mesh;
    for (let at = 0; at + 2 < positions.length; at += 3) {
        yield [positions[at] ?? 0, positions[at + 1] ?? 0, positions[at + 2] ?? 0];
    }
}

/**
 * The smallest sphere around the middle of the bounding box. A point, or nothing at all, is framed
 * without scaling, so that no infinity gets further.
 */
export function frameOf(points: readonly Vector[]): Frame {
    const bounds = boundsOf(points);
    if (!bounds) {
        return { center: [0, 0, 0], scale: 1 };
    }
    const { min, max } = bounds;
    const center: Vector = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2];
    let radius = 0;
    for (const [x, y, z] of points) {
        radius = Math.max(radius, Math.hypot(x - center[0], y - center[1], z - center[2]));
    }
    return { center, scale: radius > 0 && Number.isFinite(1 / radius) ? 1 / radius : 1 };
}

/** The mesh decides where there is one; a skeleton alone is framed by its own points. */
export function frameModel(mesh: PreviewMesh | null, skeleton: Skeleton): Frame {
    if (mesh && mesh.triangles.length > 0) {
        const { center, scale } = frameOf([...vertices(mesh)]);
        const [x, y, z] = mesh.origin;
        return { center: [x + center[0], y + center[1], z + center[2]], scale };
    }
    const lines = skeleton.branches.flatMap((branch) => branch.points);
    return frameOf([...lines, ...skeleton.nodes.map((node) => node.position)]);
}
