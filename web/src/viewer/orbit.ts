/**
 * Where the camera stands, in a space where the model fits the unit sphere around the origin and y
 * is up. Two panes that share one state turn together.
 */
export interface Orbit {
    /** Radians around the y axis, 0 on the positive z axis. */
    azimuth: number;
    /** Radians above the horizon. */
    elevation: number;
    /** In radii of the model's bounding sphere. */
    distance: number;
}

export const kFirstOrbit: Readonly<Orbit> = { azimuth: 0.62, elevation: 0.3, distance: 3.1 };

/** Short of the poles, where up would be undefined. */
export const kMostElevation = Math.PI / 2 - 0.01;
export const kNearest = 0.6;
export const kFarthest = 12;

/** What is looked at from where, as drawings have it; azimuth and elevation. */
export const kStandardViews = {
    Front: [0, 0],
    Back: [Math.PI, 0],
    Left: [-Math.PI / 2, 0],
    Right: [Math.PI / 2, 0],
    Top: [0, kMostElevation],
    Bottom: [0, -kMostElevation],
} as const;
export type StandardView = keyof typeof kStandardViews;

export function standardView(name: StandardView, { distance }: Orbit): Orbit {
    const [azimuth, elevation] = kStandardViews[name];
    return { azimuth, elevation, distance };
}

const kFullTurn = 2 * Math.PI;

function clamp(value: number, low: number, high: number): number {
    return Math.min(high, Math.max(low, value));
}

export function turned(orbit: Orbit, azimuth: number, elevation: number): Orbit {
    const around = (orbit.azimuth + azimuth) % kFullTurn;
    return {
        azimuth: around < 0 ? around + kFullTurn : around,
        elevation: clamp(orbit.elevation + elevation, -kMostElevation, kMostElevation),
        distance: orbit.distance,
    };
}

/** `factor` > 1 goes away from the model. */
export function zoomed(orbit: Orbit, factor: number): Orbit {
    return { ...orbit, distance: clamp(orbit.distance * factor, kNearest, kFarthest) };
}

export function cameraPosition(orbit: Orbit): [number, number, number] {
    const horizontal = orbit.distance * Math.cos(orbit.elevation);
    return [
        horizontal * Math.sin(orbit.azimuth),
        orbit.distance * Math.sin(orbit.elevation),
        horizontal * Math.cos(orbit.azimuth),
    ];
}
