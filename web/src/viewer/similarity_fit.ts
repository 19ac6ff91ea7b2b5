import { Matrix4, Quaternion, Vector3 } from 'three';

import { symmetricEigen } from './symmetric_eigen';

/** Points that belong together: `from[i]` is to come to `to[i]`. */
export interface Correspondence {
    from: readonly Vector3[];
    to: readonly Vector3[];
}

export function middleOf(points: readonly Vector3[]): Vector3 {
    const sum = points.reduce((total, point) => total.add(point), new Vector3());
    return points.length > 0 ? sum.divideScalar(points.length) : sum;
}

/** Root of the mean square distance from the middle. */
export function spreadOf(points: readonly Vector3[], middle = middleOf(points)): number {
    const sum = points.reduce((total, point) => total + point.distanceToSquared(middle), 0);
    return points.length > 0 ? Math.sqrt(sum / points.length) : 0;
}

/** p → scale · rotation (p - from) + to. */
export function similarity(
    from: Vector3,
    to: Vector3,
    rotation: Quaternion,
    scale: number,
): Matrix4 {
    return new Matrix4()
        .compose(to, rotation, new Vector3(scale, scale, scale))
        .multiply(new Matrix4().makeTranslation(-from.x, -from.y, -from.z));
}

/**
 * The similarity (no mirror) that brings points nearest to their counterparts, by least squares: Horn,
 * "Closed-form solution of absolute orientation using unit quaternions", JOSA A 1987, sec. 4. Fewer than
 * three points leave the rotation open: none is then made. Not `sized`: sizes stay as they are.
 */
export function fitSimilarity({ from, to }: Correspondence, sized = true): Matrix4 {
    const [a, b] = [middleOf(from), middleOf(to)];
    const spread = sized ? spreadOf(from, a) : 0;
    const scale = spread > 0 ? spreadOf(to, b) / spread || 1 : 1;
    const s = [0, 1, 2].map(() => [0, 0, 0]);
    for (const [at, point] of from.entries()) {
        const left = point.clone().sub(a).toArray();
        const right = (to[at] as Vector3).clone().sub(b).toArray();
        for (const [i, row] of s.entries()) {
            for (const [j, value] of right.entries()) {
                row[j] = (row[j] ?? 0) + (left[i] ?? 0) * value;
            }
        }
    }
    if (from.length < 3) {
        return similarity(a, b, new Quaternion(), scale);
    }
    const [
        [xx = 0, xy = 0, xz = 0] = [],
        [yx = 0, yy = 0, yz = 0] = [],
        [zx = 0, zy = 0, zz = 0] = [],
    ] = s;
    const [[w = 1, x = 0, y = 0, z = 0] = []] = symmetricEigen([
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, yy - xx - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, zz - xx - yy],
    ]).vectors;
    return similarity(a, b, new Quaternion(x, y, z, w).normalize(), scale);
}
