import { expect, it } from 'vitest';

import { branchOf, loadRig } from '../../src/viewer/rig';
import { rigFile } from '../rig_sample';

it('finds the parts in their order and the bones with their branches', async () => {
    const rig = await loadRig(rigFile());
    expect(rig.parts).toHaveLength(2);
    const first = rig.parts.map((part) => part.geometry.getAttribute('position').getX(0));
    expect(first).toEqual([0, 1]);
    expect(rig.bones.map(branchOf)).toEqual([null, 0, 1, null]);
});

it('knows from where vertices are counted, to the last place', async () => {
    expect((await loadRig(rigFile())).origin).toEqual([0, 0, 0]);
    const far = await loadRig(rigFile({ origin: [4123456.789, -7e6, 0.5] }));
    expect(far.origin).toEqual([4123456.789, -7e6, 0.5]);
});

it('refuses what is no glTF', async () => {
    await expect(loadRig(new TextEncoder().encode('<html>').buffer)).rejects.toThrow();
});
