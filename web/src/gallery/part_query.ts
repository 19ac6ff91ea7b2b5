import type { PreviewMesh, SkeletonBranch } from '../api/elements';
import type { Segments, Vector } from '../api/types';
import { buildTube } from '../viewer/tube';

type Triangle = [number, number, number];

function offFile(name: string, points: readonly Vector[], triangles: readonly Triangle[]): File {
    const lines = [
        'OFF',
        `${points.length} ${triangles.length} 0`,
        ...points.map((point) => point.join(' ')),
        ...triangles.map((corners) => `3 ${corners.join(' ')}`),
    ];
    return new File([`${lines.join('\n')}\n`], `${name}.off`, { type: 'model/off' });
}

/** Edges of only one triangle, each from its first end to its second. */
function openEdges(triangles: readonly Triangle[]): Map<number, number[]> {
    const edges = new Set<string>();
    for (const [a, b, c] of triangles) {
        for (const edge of [`${a} ${b}`, `${b} ${c}`, `${c} ${a}`]) {
            edges.add(edge);
        }
    }
    const open = new Map<number, number[]>();
    for (const edge of edges) {
        const [from = 0, to = 0] = edge.split(' ').map(Number);
        if (!edges.has(`${to} ${from}`)) {
            open.set(from, [...(open.get(from) ?? []), to]);
        }
    }
    return open;
}

/** Closes each hole that was cut by a fan around its middle. */
function closed(points: Vector[], triangles: readonly Triangle[]): Triangle[] {
    const all = [...triangles];
    const open = openEdges(triangles);
    for (const [start] of open) {
        const loop: number[] = [];
        for (let at: number | undefined = start; at !== undefined; at = open.get(at)?.pop()) {
            loop.push(at);
        }
        if (loop.length < 4) {
            continue;
        }
        const rim = loop.slice(0, -1);
        const middle = points.length;
        points.push(
            [0, 1, 2].map(
                (axis) => rim.reduce((sum, at) => sum + (points[at]?.[axis] ?? 0), 0) / rim.length,
            ) as Vector,
        );
        for (const [at, from] of rim.entries()) {
            all.push([loop[at + 1] ?? from, from, middle]);
        }
    }
    return all;
}

/** One part of a model as a model of its own, closed where it was cut off. */
export function partFile(
    name: string,
    mesh: PreviewMesh,
    labels: Segments['labels'],
    part: number,
): File {
    const places = new Map<number, number>();
    const points: Vector[] = [];
    const triangles: Triangle[] = [];
    for (const [triangle, label] of labels.entries()) {
        if (label !== part) {
            continue;
        }
        const corners = mesh.triangles.slice(3 * triangle, 3 * triangle + 3).map((vertex) => {
            const known = places.get(vertex);
            if (known !== undefined) {
                return known;
            }
            places.set(vertex, points.length);
            points.push(mesh.positions.slice(3 * vertex, 3 * vertex + 3) as Vector);
            return points.length - 1;
        });
        triangles.push(corners as Triangle);
    }
    return offFile(name, points, closed(points, triangles));
}

/** What a branch of a skeleton stands for: a tube along it as thick as the model is there. */
export function branchFile(name: string, { points: line, radii }: SkeletonBranch): File {
    const { positions, indices } = buildTube(line, radii, 12);
    const points: Vector[] = [];
    for (let at = 0; at + 2 < positions.length; at += 3) {
        points.push([...positions.slice(at, at + 3)] as Vector);
    }
    const triangles: Triangle[] = [];
    for (let at = 0; at + 2 < indices.length; at += 3) {
        triangles.push([...indices.slice(at, at + 3)] as Triangle);
    }
    return offFile(name, points, closed(points, triangles));
}
