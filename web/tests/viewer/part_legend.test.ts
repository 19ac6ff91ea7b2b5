import { expect, it, vi } from 'vitest';

import { partLegend } from '../../src/viewer/part_legend';
import { kSegments } from '../rig_sample';

it('names each part by a number and its share of the surface', () => {
    const onChoose = vi.fn();
    const onFind = vi.fn();
    const legend = partLegend({
        parts: kSegments.parts,
        colors: ['#111111', '#222222'],
        onChoose,
        onFind,
    });
    const rows = [...legend.node.querySelectorAll('tbody tr')];
    expect(rows.map((row) => row.textContent)).toEqual(['175.0 %Find', '225.0 %Find']);
    rows[1]?.dispatchEvent(new Event('focusin'));
    expect(onChoose).toHaveBeenLastCalledWith(1);
    rows[1]?.dispatchEvent(new Event('focusout'));
    expect(onChoose).toHaveBeenLastCalledWith(null);
    rows[1]?.querySelector('button')?.click();
    expect(onFind).toHaveBeenLastCalledWith(1);
    legend.highlight(1);
    expect(rows.map((row) => row.classList.contains('chosen'))).toEqual([false, true]);
});
