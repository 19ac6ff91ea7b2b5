import type { Vector } from '../api/types';

/** Ready for a vertex buffer: three numbers a vertex, three indices a triangle. */
export interface Tube {
    positions: Float32Array;
    normals: Float32Array;
    indices: Uint32Array;
}

function subtract(a: Vector, b: Vector): Vector {
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function cross(a: Vector, b: Vector): Vector {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function dot(a: Vector, b: Vector): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function normalised(a: Vector): Vector {
    const length = Math.hypot(...a);
    return length > 0 ? [a[0] / length, a[1] / length, a[2] / length] : [0, 0, 0];
}

/** Which points to keep: two equal ones in a row have no direction between them. */
function withoutRepeats(points: readonly Vector[]): number[] {
    const kept: number[] = [];
    for (const [index, point] of points.entries()) {
        const last = points[kept.at(-1) ?? -1];
        if (point.every(Number.isFinite) && (!last || Math.hypot(...subtract(point, last)) > 0)) {
            kept.push(index);
        }
    }
    return kept;
}

/** Any direction square to `tangent`: the axis that it has least of shows where. */
function anyNormal(tangent: Vector): Vector {
    const size = tangent.map(Math.abs) as Vector;
    const least = size.indexOf(Math.min(...size));
    const axis: Vector = [0, 0, 0];
    axis[least] = 1;
    return normalised(cross(tangent, axis));
}

function tangentAt(points: readonly Vector[], index: number): Vector {
    const before = points[Math.max(0, index - 1)] as Vector;
    const here = points[index] as Vector;
    const after = points[Math.min(points.length - 1, index + 1)] as Vector;
    const mean = normalised(subtract(after, before));
    // A branch that turns straight back has no mean direction at its turning point.
    return dot(mean, mean) > 0 ? mean : normalised(subtract(after, here));
}

/**
 * A tube along a polyline, of one radius or of one for each of its points. Its rings are carried along without twist (each
 * normal is the last one made square to the new direction). Fewer than two distinct points give an
 * empty tube. The ends stay open: the spheres of the nodes sit on them.
 */
export function buildTube(
    line: readonly Vector[],
    radius: number | readonly number[],
    sides = 10,
): Tube {
    const kept = withoutRepeats(line);
    const points = kept.map((index) => line[index] as Vector);
    if (points.length < 2) {
        return {
            positions: new Float32Array(),
            normals: new Float32Array(),
            indices: new Uint32Array(),
        };
    }
    const positions = new Float32Array(points.length * sides * 3);
    const normals = new Float32Array(points.length * sides * 3);
    let normal = anyNormal(tangentAt(points, 0));
    for (const [ring, center] of points.entries()) {
        const tangent = tangentAt(points, ring);
        const wide = typeof radius === 'number' ? radius : (radius[kept[ring] ?? 0] ?? 0);
        const along = dot(normal, tangent);
        const square = subtract(normal, [
            along * tangent[0],
            along * tangent[1],
            along * tangent[2],
        ]);
        normal = Math.hypot(...square) > 1e-9 ? normalised(square) : anyNormal(tangent);
        const binormal = cross(tangent, normal);
        for (let side = 0; side < sides; side++) {
            const angle = (2 * Math.PI * side) / sides;
            const base = (ring * sides + side) * 3;
            for (const axis of [0, 1, 2] as const) {
                const outwards = Math.cos(angle) * normal[axis] + Math.sin(angle) * binormal[axis];
                normals[base + axis] = outwards;
                positions[base + axis] = center[axis] + wide * outwards;
            }
        }
    }
    return { positions, normals, indices: ringIndices(points.length, sides) };
}

function ringIndices(rings: number, sides: number): Uint32Array {
    const indices = new Uint32Array((rings - 1) * sides * 6);
    let at = 0;
    for (let ring = 0; ring + 1 < rings; ring++) {
        for (let side = 0; side < sides; side++) {
            const a = ring * sides + side;
            const b = ring * sides + ((side + 1) % sides);
            indices.set([a, b, a + sides, b, b + sides, a + sides], at);
            at += 6;
        }
    }
    return indices;
}
