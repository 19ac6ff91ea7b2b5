import { Object3D, Vector3 } from 'three';
import { expect, it, vi } from 'vitest';

import { Stand, upControl } from '../../src/viewer/up_axis';

/** Where a point of a model is shown that stands with `up` upwards. */
function shown(up: 'x' | 'y' | 'z', point: Vector3): Vector3 {
    const stand = new Stand();
    const model = new Object3D();
    stand.add(model);
    stand.upAxis = up;
    return model.localToWorld(point.clone());
}

it('stands models upright, by a turn that is no mirror', () => {
    const up = new Vector3(0, 1, 0);
    expect(shown('y', up)).toEqual(up);
    expect(shown('z', new Vector3(0, 0, 1)).distanceTo(up)).toBeLessThan(1e-12);
    expect(shown('x', new Vector3(1, 0, 0)).distanceTo(up)).toBeLessThan(1e-12);
    for (const axis of ['x', 'z'] as const) {
        const [x, y, z] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map(
            (direction) => shown(axis, direction),
        );
        expect(x?.cross(y as Vector3).distanceTo(z as Vector3)).toBeLessThan(1e-12);
    }
});

it('offers x where a file says so, and not otherwise', () => {
    const offered = (up: 'x' | 'y') =>
        [...upControl(up, vi.fn()).querySelectorAll('button')].map((button) => button.value);
    expect(offered('x')).toEqual(['x', 'y', 'z']);
    expect(offered('y')).toEqual(['y', 'z']);
});

it('goes back to where it was', () => {
    const stand = new Stand();
    stand.upAxis = 'z';
    stand.upAxis = 'y';
    expect(stand.rotation.x).toBe(0);
});

it('says which axis points up, and changes it by a press', () => {
    const onChange = vi.fn();
    const node = upControl('z', onChange);
    const pressed = () => node.querySelector('[aria-pressed=true]')?.textContent;
    expect(node.querySelectorAll('[aria-pressed=true]')).toHaveLength(1);
    expect(pressed()).toBe('z up');
    node.querySelector<HTMLButtonElement>('[value=y]')?.click();
    expect(onChange).toHaveBeenCalledExactlyOnceWith('y');
    expect(pressed()).toBe('y up');
});
