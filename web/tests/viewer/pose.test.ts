import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';

import { findHandles, Pose, positionOf, reach } from '../../src/viewer/pose';
import { loadRig } from '../../src/viewer/rig';
import { rigFile } from '../rig_sample';
import { randomNumbers } from '../sample';

describe('findHandles', () => {
    it('gives each branch one at its far end, and none to the root', async () => {
        const { bones } = await loadRig(rigFile());
        const handles = findHandles(bones);
        expect(handles.map(({ number }) => number)).toEqual([1, 2]);
        expect(handles.map(({ pivot }) => bones.indexOf(pivot))).toEqual([1, 2]);
        expect(handles.map(({ end }) => bones.indexOf(end))).toEqual([2, 3]);
    });

    it('finds none without branches', async () => {
        expect(findHandles((await loadRig(rigFile({ withBranches: false }))).bones)).toEqual([]);
    });
});

describe('Pose', () => {
    it('turns a limb towards what it is dragged to, and all that hangs on it', async () => {
        const { bones } = await loadRig(rigFile());
        const [shoulder, elbow] = findHandles(bones);
        if (!shoulder || !elbow) {
            throw new Error('handles are missing');
        }
        const pose = new Pose(bones);
        expect(pose.resting).toBe(true);
        pose.swing(shoulder, new Vector3(0, 5, 0));
        expect(positionOf(shoulder.end).distanceTo(new Vector3(0, 1, 0))).toBeLessThan(1e-6);
        expect(positionOf(elbow.end).distanceTo(new Vector3(0, 2, 0))).toBeLessThan(1e-6);
        pose.swing(elbow, new Vector3(1, 1, 0));
        expect(positionOf(elbow.end).distanceTo(new Vector3(1, 1, 0))).toBeLessThan(1e-6);
        expect(pose.resting).toBe(false);
        pose.reset([elbow.pivot]);
        expect(positionOf(elbow.end).distanceTo(new Vector3(0, 2, 0))).toBeLessThan(1e-6);
        pose.reset();
        expect(pose.resting).toBe(true);
        expect(positionOf(elbow.end).toArray()).toEqual([2, 0, 0]);
    });

    it('stays where it is when it is dragged onto its own pivot', async () => {
        const { bones } = await loadRig(rigFile());
        const [shoulder] = findHandles(bones);
        const pose = new Pose(bones);
        if (shoulder) {
            pose.swing(shoulder, positionOf(shoulder.pivot));
        }
        expect(pose.resting).toBe(true);
    });
});

describe('what was done to a pose', () => {
    async function posed() {
        const { bones } = await loadRig(rigFile());
        const [shoulder, elbow] = findHandles(bones);
        if (!shoulder || !elbow) {
            throw new Error('handles are missing');
        }
        return { pose: new Pose(bones), shoulder, elbow };
    }

    it('is taken back step by step, and done again', async () => {
        const { pose, shoulder, elbow } = await posed();
        const tip = () => positionOf(elbow.end).toArray();
        const places = [tip()];
        for (const target of [new Vector3(0, 5, 0), new Vector3(0, -5, 1)]) {
            pose.swing(shoulder, target);
            expect(pose.commit()).toBe(true);
            places.push(tip());
        }
        expect(pose.commit()).toBe(false);
        for (const place of [places[1], places[0], places[0]]) {
            pose.undo();
            expect(tip()).toEqual(place);
        }
        expect(pose.canUndo).toBe(false);
        for (const place of [places[1], places[2], places[2]]) {
            pose.redo();
            expect(tip()).toEqual(place);
        }
        pose.undo();
        pose.reset();
        pose.commit();
        expect(pose.canRedo).toBe(false);
        pose.undo();
        expect(tip()).toEqual(places[1]);
    });

    it('can be told, and told again', async () => {
        const { pose, shoulder, elbow } = await posed();
        expect(pose.text).toBe('');
        pose.swing(shoulder, new Vector3(0.3, 1, -0.2));
        pose.swing(elbow, new Vector3(-3, 1, 2));
        const tip = positionOf(elbow.end);
        const { text } = pose;
        const other = await posed();
        other.pose.text = text;
        expect(positionOf(other.elbow.end).distanceTo(tip)).toBeLessThan(0.01);
        expect(other.pose.text).toBe(text);
        expect(other.pose.canUndo).toBe(false);
        for (const odd of ['x', '99.1.1.1', '1.9999.0.0', '1.2', '']) {
            other.pose.text = odd;
            expect(other.pose.resting).toBe(true);
        }
    });
});

describe('reach', () => {
    it('keeps the length of the limb, and lies under the pointer where that can be', () => {
        const random = randomNumbers(3);
        const some = () => new Vector3(random() - 0.5, random() - 0.5, random() - 0.5);
        for (let trial = 0; trial < 200; trial++) {
            const center = some();
            const current = some();
            const origin = new Vector3(0, 0, 4);
            const direction = some().sub(origin).normalize();
            const target = reach({ origin, direction }, center, current);
            const radius = current.distanceTo(center);
            expect(target.distanceTo(center)).toBeCloseTo(radius, 9);
            const away = (point: Vector3) => point.clone().sub(origin).cross(direction).length();
            const least = Math.max(0, away(center) - radius);
            expect(away(target)).toBeCloseTo(least, 6);
        }
    });

    it('stays on the side of the pivot that the limb is on', () => {
        const ray = { origin: new Vector3(0.1, 0, 4), direction: new Vector3(0, 0, -1) };
        const center = new Vector3(0, 0, 0);
        expect(reach(ray, center, new Vector3(0, 0.1, 1)).z).toBeGreaterThan(0);
        expect(reach(ray, center, new Vector3(0, 0.1, -1)).z).toBeLessThan(0);
    });
});
