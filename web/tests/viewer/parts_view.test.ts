import { expect, it } from 'vitest';

import { partsView } from '../../src/viewer/parts_view';
import { kSegments, rigFile } from '../rig_sample';
import { kSkeleton } from '../sample';

it('keeps its legend where there is no WebGL', async () => {
    const view = await partsView({
        name: 'pig',
        skeleton: kSkeleton,
        segments: kSegments,
        rig: rigFile(),
        up: 'z',
        posed: '',
        onPose: () => {},
        onFind: () => {},
    });
    expect(view.node.querySelector('.no-webgl')).not.toBeNull();
    expect(view.node.querySelectorAll('.part-legend tbody tr')).toHaveLength(2);
    expect(view.node.querySelector('.match-summary')?.textContent).toBe('2 parts.');
    view.dispose();
});
