export interface ScreenPoint {
    x: number;
    y: number;
}

export interface ScreenLine {
    id: number;
    points: readonly ScreenPoint[];
}

/** Distance of a point to a segment, in the unit of both. */
export function distanceToSegment(at: ScreenPoint, a: ScreenPoint, b: ScreenPoint): number {
    const along = { x: b.x - a.x, y: b.y - a.y };
    const square = along.x * along.x + along.y * along.y;
    const share = square > 0 ? ((at.x - a.x) * along.x + (at.y - a.y) * along.y) / square : 0;
    const held = Math.min(1, Math.max(0, share));
    return Math.hypot(at.x - a.x - held * along.x, at.y - a.y - held * along.y);
}

/**
 * The line nearest to the pointer, or null where none is within `tolerance`. On the screen instead
 * of with a ray through the scene, because a tube a few pixels wide is hard to hit.
 */
export function nearestLine(
    lines: readonly ScreenLine[],
    at: ScreenPoint,
    tolerance: number,
): number | null {
    let nearest: number | null = null;
    let least = tolerance;
    for (const line of lines) {
        for (let index = 0; index + 1 < line.points.length; index++) {
            const a = line.points[index] as ScreenPoint;
            const b = line.points[index + 1] as ScreenPoint;
            const distance = distanceToSegment(at, a, b);
            if (distance < least) {
                least = distance;
                nearest = line.id;
            }
        }
    }
    return nearest;
}
