import { Triangle, Vector3 } from 'three';

/** A triangle with the sphere that it lies in, so that most need not be looked at. */
interface Ball {
    triangle: Triangle;
    middle: Vector3;
    radius: number;
}

/** Where on a surface the nearest point to another point is. */
export class SurfaceDistance {
    private readonly balls_: Ball[] = [];
    private readonly found_ = new Vector3();
    /** Of the last answer: neighbours in a list of points are mostly near to the same triangle. */
    private last_ = 0;

    /** @param corners three numbers a corner, three corners a triangle */
    constructor(corners: ArrayLike<number>) {
        for (let at = 0; at + 8 < corners.length; at += 9) {
            const corner = (from: number): Vector3 =>
                new Vector3(corners[from], corners[from + 1], corners[from + 2]);
            const triangle = new Triangle(corner(at), corner(at + 3), corner(at + 6));
            const middle = triangle.getMidpoint(new Vector3());
            const radius = Math.max(
                ...[triangle.a, triangle.b, triangle.c].map((each) => each.distanceTo(middle)),
            );
            this.balls_.push({ triangle, middle, radius });
        }
    }

    /** Writes the nearest point to `nearest`. Infinite for a surface without triangles. */
    to(point: Vector3, nearest = new Vector3()): number {
        let least = Number.POSITIVE_INFINITY;
        const look = (at: number): void => {
            const { triangle, middle, radius } = this.balls_[at] as Ball;
            const reach = least + radius;
            if (middle.distanceToSquared(point) >= reach * reach) {
                return;
            }
            triangle.closestPointToPoint(point, this.found_);
            const distance = this.found_.distanceTo(point);
            if (distance < least) {
                least = distance;
                nearest.copy(this.found_);
                this.last_ = at;
            }
        };
        if (this.balls_.length > 0) {
            look(this.last_);
        }
        for (let at = 0; at < this.balls_.length; at++) {
            look(at);
        }
        return least;
    }
}
