import { describe, expect, it } from 'vitest';

import {
    cameraPosition,
    kFarthest,
    kFirstOrbit,
    kMostElevation,
    kNearest,
    turned,
    zoomed,
} from '../../src/viewer/orbit';

describe('an orbit', () => {
    it('keeps its distance to the model while it turns', () => {
        let orbit = { ...kFirstOrbit };
        for (let step = 0; step < 100; step++) {
            orbit = turned(orbit, 0.7, 0.3);
            expect(Math.hypot(...cameraPosition(orbit))).toBeCloseTo(orbit.distance, 9);
            expect(Math.abs(orbit.elevation)).toBeLessThanOrEqual(kMostElevation);
            expect(orbit.azimuth).toBeGreaterThanOrEqual(0);
            expect(orbit.azimuth).toBeLessThan(2 * Math.PI);
        }
    });

    it('comes back after a full turn', () => {
        const around = turned(kFirstOrbit, 2 * Math.PI, 0);
        for (const [axis, value] of cameraPosition(around).entries()) {
            expect(value).toBeCloseTo(cameraPosition(kFirstOrbit)[axis] ?? Number.NaN, 9);
        }
    });

    it('never reaches a pole, the model or infinity', () => {
        expect(turned(kFirstOrbit, 0, 99).elevation).toBe(kMostElevation);
        expect(zoomed(kFirstOrbit, 0).distance).toBe(kNearest);
        expect(zoomed(kFirstOrbit, 1e9).distance).toBe(kFarthest);
    });

    it('is not changed by what is derived from it', () => {
        const before = { ...kFirstOrbit };
        turned(kFirstOrbit, 1, 1);
        zoomed(kFirstOrbit, 2);
        expect(kFirstOrbit).toEqual(before);
    });

    it('looks along z at azimuth and elevation 0', () => {
        expect(cameraPosition({ azimuth: 0, elevation: 0, distance: 2 })).toEqual([0, 0, 2]);
    });
});
