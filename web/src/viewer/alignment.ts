import { Matrix4, Quaternion, Vector3 } from 'three';

import {
    type Correspondence,
    fitSimilarity,
    middleOf,
    similarity,
    spreadOf,
} from './similarity_fit';
import { SurfaceDistance } from './surface_distance';
import { symmetricEigen } from './symmetric_eigen';

/** A surface as corners of triangles, three numbers each. */
export type Corners = Float32Array;

const kSamples = 240;
const kSteps = 12;

/** Points spread evenly over a surface, the same each time. */
export function samplePoints(corners: Corners, count: number): Vector3[] {
    const at = (corner: number): Vector3 => new Vector3().fromArray(corners, 3 * corner);
    const triangles = Math.floor(corners.length / 9);
    const sums: number[] = [];
    let area = 0;
    for (let each = 0; each < triangles; each++) {
        const [a, b, c] = [at(3 * each), at(3 * each + 1), at(3 * each + 2)];
        area += b.sub(a).cross(c.sub(a)).length() / 2;
        sums.push(area);
    }
    const points: Vector3[] = [];
    let triangle = 0;
    for (let each = 0; each < count && area > 0; each++) {
        const wanted = (area * (each + 0.5)) / count;
        while (triangle + 1 < triangles && (sums[triangle] ?? 0) < wanted) {
            triangle += 1;
        }
        // A low-discrepancy pair, folded into the triangle.
        let [u, v] = [(each * 0.7548776662) % 1, (each * 0.5698402909) % 1];
        if (u + v > 1) {
            [u, v] = [1 - u, 1 - v];
        }
        const [a, b, c] = [at(3 * triangle), at(3 * triangle + 1), at(3 * triangle + 2)];
        points.push(a.clone().addScaledVector(b.sub(a), u).addScaledVector(c.sub(a), v));
    }
    return points;
}

/** Principal axes as the columns of a rotation, the longest first. */
function principalAxes(points: readonly Vector3[], middle: Vector3): Quaternion {
    const covariance = [0, 1, 2].map(() => [0, 0, 0]);
    for (const point of points) {
        const offset = point.clone().sub(middle).toArray();
        for (const [i, row] of covariance.entries()) {
            for (const [j, value] of offset.entries()) {
                row[j] = (row[j] ?? 0) + (offset[i] ?? 0) * value;
            }
        }
    }
    const [first = [1, 0, 0], second = [0, 1, 0]] = symmetricEigen(covariance).vectors;
    const x = new Vector3().fromArray(first);
    const y = new Vector3().fromArray(second);
    return new Quaternion().setFromRotationMatrix(
        new Matrix4().makeBasis(x, y, x.clone().cross(y)),
    );
}

/** The 24 rotations that take axes to axes. */
function axisRotations(): Quaternion[] {
    const units = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
    const signed = units.flatMap((unit) => [unit, unit.clone().negate()]);
    return signed.flatMap((x) =>
        signed
            .filter((y) => x.dot(y) === 0)
            .map((y) =>
                new Quaternion().setFromRotationMatrix(
                    new Matrix4().makeBasis(x, y, x.clone().cross(y)),
                ),
            ),
    );
}

function meanDistance(points: readonly Vector3[], by: Matrix4, to: SurfaceDistance): number {
    const moved = new Vector3();
    const sum = points.reduce(
        (total, point) => total + to.to(moved.copy(point).applyMatrix4(by)),
        0,
    );
    return sum / Math.max(1, points.length);
}

interface Start {
    matrix: Matrix4;
    weight: number;
}

/** Of what has to be that much nearer than the others. */
const kOddWeight = 2;

export interface Alignment {
    /** Brings the second surface onto the first. */
    matrix: Matrix4;
    /** From the second to the first, of sample points. */
    meanDistance: number;
}

/**
 * Lets each point find its nearest, and the whole follow them, over and over (Besl and McKay, "A method for
 * registration of 3-D shapes", PAMI 1992). The size stays: a point is what is nearest to everything.
 */
function* refine(
    points: readonly Vector3[],
    start: Matrix4,
    target: SurfaceDistance,
): Generator<void, Alignment> {
    let best: Alignment = { matrix: start, meanDistance: meanDistance(points, start, target) };
    for (let step = 0; step < kSteps; step++) {
        yield;
        const from = points.map((point) => point.clone().applyMatrix4(best.matrix));
        const to = from.map((point) => {
            const nearest = new Vector3();
            target.to(point, nearest);
            return nearest;
        });
        yield;
        const matrix = fitSimilarity({ from, to }, false).multiply(best.matrix);
        const distance = meanDistance(points, matrix, target);
        if (!(distance < best.meanDistance * 0.999)) {
            break;
        }
        best = { matrix, meanDistance: distance };
    }
    return best;
}

/**
 * Lays one surface over another, a step at a time, up to place, rotation and size. Of the ways that matched nodes of their
 * skeletons, their principal axes and the rotations `upright` suggest the one that comes nearest is refined.
 * Unlike things lie nearest to each other in odd ways: one that is neither upright nor what the nodes say has
 * to be much nearer.
 */
export function* alignment(
    first: Corners,
    second: Corners,
    matched: Correspondence,
    upright: readonly Quaternion[] = [],
): Generator<void, Alignment> {
    const target = new SurfaceDistance(first);
    yield;
    const [here, there] = [samplePoints(second, kSamples), samplePoints(first, kSamples)];
    const [a, b] = [middleOf(here), middleOf(there)];
    const spread = spreadOf(here, a);
    const scale = spread > 0 ? spreadOf(there, b) / spread : 1;
    const [axes, wanted] = [principalAxes(here, a), principalAxes(there, b)];
    const start = (turn: Quaternion, weight: number): Start => ({
        matrix: similarity(a, b, turn, scale),
        weight,
    });
    const starts = [
        ...upright.map((turn) => start(turn, 1)),
        ...axisRotations().map((turn) =>
            start(
                wanted.clone().multiply(turn).multiply(axes.clone().invert()),
                upright.length > 0 ? kOddWeight : 1,
            ),
        ),
    ];
    if (matched.from.length >= 3) {
        starts.unshift({ matrix: fitSimilarity(matched), weight: 1 });
    }
    // A part that lies well within the other is near to it, but does not cover it: both ways count.
    const source = new SurfaceDistance(second);
    const few = (points: Vector3[]): Vector3[] => points.filter((_, at) => at % 8 === 0);
    let best = { matrix: new Matrix4(), cost: Number.POSITIVE_INFINITY };
    for (const { matrix, weight } of starts) {
        yield;
        const cost =
            weight *
            (meanDistance(few(here), matrix, target) +
                meanDistance(few(there), matrix.clone().invert(), source) *
                    matrix.getMaxScaleOnAxis());
        if (cost < best.cost) {
            best = { matrix, cost };
        }
    }
    return yield* refine(here, best.matrix, target);
}
