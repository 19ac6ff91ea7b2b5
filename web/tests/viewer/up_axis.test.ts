import { Object3D, Vector3 } from 'three';
import { expect, it, vi } from 'vitest';

import { Stand, upControl } from '../../src/viewer/up_axis';

/** Where a point of a model is shown that stands with `up` upwards. */
function shown(up: 'y' | 'z', point: Vector3): Vector3 {
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
    const [x, y, z] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map(
        (axis) => shown('z', axis),
    );
    expect(x?.cross(y as Vector3).distanceTo(z as Vector3)).toBeLessThan(1e-12);
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
