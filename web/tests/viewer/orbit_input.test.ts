import { describe, expect, it, vi } from 'vitest';

import { kFirstOrbit } from '../../src/viewer/orbit';
import { attachOrbitInput, OrbitSource } from '../../src/viewer/orbit_input';

function target(): HTMLElement {
    const node = document.createElement('div');
    node.setPointerCapture = () => {};
    return node;
}

function pointer(type: string, x: number, y: number, pointerId = 1): PointerEvent {
    return new PointerEvent(type, { clientX: x, clientY: y, pointerId });
}

describe('OrbitSource', () => {
    it('tells all who share it', () => {
        const source = new OrbitSource();
        const [first, second] = [vi.fn(), vi.fn()];
        const leave = source.subscribe(first);
        source.subscribe(second);
        source.set({ ...kFirstOrbit, azimuth: 1 });
        leave();
        source.set({ ...kFirstOrbit, azimuth: 2 });
        expect(first).toHaveBeenCalledOnce();
        expect(second).toHaveBeenCalledTimes(2);
        expect(source.orbit.azimuth).toBe(2);
    });
});

describe('attachOrbitInput', () => {
    it('turns by dragging, and only while a button is down', () => {
        const [node, source] = [target(), new OrbitSource()];
        attachOrbitInput(node, () => source);
        node.dispatchEvent(pointer('pointermove', 50, 50));
        expect(source.orbit).toEqual(kFirstOrbit);
        node.dispatchEvent(pointer('pointerdown', 50, 50));
        node.dispatchEvent(pointer('pointermove', 40, 60));
        expect(source.orbit.azimuth).toBeGreaterThan(kFirstOrbit.azimuth);
        expect(source.orbit.elevation).toBeGreaterThan(kFirstOrbit.elevation);
        const { orbit } = source;
        node.dispatchEvent(pointer('pointerup', 40, 60));
        node.dispatchEvent(pointer('pointermove', 0, 0));
        expect(source.orbit).toBe(orbit);
    });

    it('zooms by pinching without turning', () => {
        const [node, source] = [target(), new OrbitSource()];
        attachOrbitInput(node, () => source);
        node.dispatchEvent(pointer('pointerdown', 0, 0, 1));
        node.dispatchEvent(pointer('pointerdown', 100, 0, 2));
        node.dispatchEvent(pointer('pointermove', 200, 0, 2));
        expect(source.orbit.distance).toBeCloseTo(kFirstOrbit.distance / 2, 9);
        expect(source.orbit.azimuth).toBe(kFirstOrbit.azimuth);
    });

    it('leaves the wheel to the page until one has taken to the picture', () => {
        const [node, source] = [target(), new OrbitSource()];
        attachOrbitInput(node, () => source);
        const wheel = (ctrlKey = false) => {
            const event = new WheelEvent('wheel', { deltaY: 100, cancelable: true });
            Object.defineProperty(event, 'ctrlKey', { value: ctrlKey });
            node.dispatchEvent(event);
            return event.defaultPrevented;
        };
        expect(wheel()).toBe(false);
        expect(source.orbit).toEqual(kFirstOrbit);
        expect(wheel(true)).toBe(true);
    });

    it('zooms by the wheel in a window of its own and keeps the page from scrolling', () => {
        const [node, source] = [target(), new OrbitSource()];
        document.createElement('dialog').append(node);
        attachOrbitInput(node, () => source);
        const away = new WheelEvent('wheel', { deltaY: 100, cancelable: true });
        node.dispatchEvent(away);
        expect(away.defaultPrevented).toBe(true);
        expect(source.orbit.distance).toBeGreaterThan(kFirstOrbit.distance);
    });

    it.each(['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', '+', '-'])(
        'answers to the key %s, and Home undoes it',
        (key) => {
            const [node, source] = [target(), new OrbitSource()];
            attachOrbitInput(node, () => source);
            node.dispatchEvent(new KeyboardEvent('keydown', { key }));
            expect(source.orbit).not.toEqual(kFirstOrbit);
            node.dispatchEvent(new KeyboardEvent('keydown', { key: 'Home' }));
            expect(source.orbit).toEqual(kFirstOrbit);
        },
    );

    it('leaves other keys and shortcuts to the browser', () => {
        const [node, source] = [target(), new OrbitSource()];
        attachOrbitInput(node, () => source);
        for (const init of [{ key: 'Tab' }, { key: '+', ctrlKey: true }, { key: 'Escape' }]) {
            const event = new KeyboardEvent('keydown', { ...init, cancelable: true });
            node.dispatchEvent(event);
            expect(event.defaultPrevented).toBe(false);
        }
        expect(source.orbit).toEqual(kFirstOrbit);
    });

    it('hears nothing any more once it is undone', () => {
        const [node, source] = [target(), new OrbitSource()];
        attachOrbitInput(node, () => source)();
        node.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
        expect(source.orbit).toEqual(kFirstOrbit);
    });
});
