import { Bone } from 'three';
import { expect, it, vi } from 'vitest';

import { JointHandles } from '../../src/viewer/joint_handles';

function made() {
    const handle = { number: 1, pivot: new Bone(), end: new Bone() };
    const calls = { onDrag: vi.fn(), onStep: vi.fn(), onReset: vi.fn(), onDone: vi.fn() };
    const joints = new JointHandles({
        handles: [handle],
        locate: () => ({ x: 100, y: 50, depth: 0.5 }),
        pointOf: (event) => ({ x: event.clientX, y: event.clientY }),
        ...calls,
    });
    const button = joints.node.querySelector('button') as HTMLButtonElement;
    button.setPointerCapture = () => {};
    const point = (type: string, clientX: number, clientY: number) =>
        button.dispatchEvent(new PointerEvent(type, { clientX, clientY, button: 0 }));
    const key = (name: string, more: KeyboardEventInit = {}) =>
        button.dispatchEvent(
            new KeyboardEvent('keydown', { key: name, cancelable: true, ...more }),
        );
    return { handle, joints, button, point, key, ...calls };
}

it('lies over its joint', () => {
    const { joints, button } = made();
    joints.place();
    expect(button.style.getPropertyValue('--x')).toBe('100.00px');
    expect(button.style.getPropertyValue('--y')).toBe('50.00px');
});

it('drags from where it was taken, and only while it is held', () => {
    const { handle, point, onDrag, onDone } = made();
    point('pointermove', 90, 60);
    expect(onDrag).not.toHaveBeenCalled();
    point('pointerdown', 103, 52);
    point('pointermove', 113, 72);
    expect(onDrag).toHaveBeenLastCalledWith(handle, { x: 110, y: 70 });
    expect(onDone).not.toHaveBeenCalled();
    point('pointerup', 113, 72);
    expect(onDone).toHaveBeenCalledOnce();
    point('pointermove', 0, 0);
    expect(onDrag).toHaveBeenCalledTimes(1);
});

it('moves with the arrow keys, goes back with Home, and leaves other keys alone', () => {
    const { handle, key, onStep, onReset } = made();
    expect(key('ArrowUp')).toBe(false);
    expect(onStep).toHaveBeenLastCalledWith(handle, 0, 1);
    key('ArrowLeft');
    expect(onStep).toHaveBeenLastCalledWith(handle, -1, 0);
    key('Home');
    expect(onReset).toHaveBeenLastCalledWith(handle);
    expect(key('Tab')).toBe(true);
    expect(key('ArrowUp', { altKey: true })).toBe(true);
    expect(onStep).toHaveBeenCalledTimes(2);
});
