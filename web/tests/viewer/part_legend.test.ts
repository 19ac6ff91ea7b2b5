import { expect, it, vi } from 'vitest';

import { partLegend } from '../../src/viewer/part_legend';
import { kSegments } from '../rig_sample';

it('names each part by a number and its share of the surface', () => {
    const onChoose = vi.fn();
    const legend = partLegend({ parts: kSegments.parts, colors: ['#111111', '#222222'], onChoose });
    const rows = [...legend.node.querySelectorAll('tbody tr')];
    expect(rows.map((row) => row.textContent)).toEqual(['175.0 %', '225.0 %']);
    rows[1]?.dispatchEvent(new Event('focus'));
    expect(onChoose).toHaveBeenLastCalledWith(1);
    rows[1]?.dispatchEvent(new Event('blur'));
    expect(onChoose).toHaveBeenLastCalledWith(null);
    legend.highlight(1);
    expect(rows.map((row) => row.classList.contains('chosen'))).toEqual([false, true]);
});
