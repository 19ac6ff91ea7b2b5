import { describe, expect, it } from 'vitest';

import type { MeshColours } from '../../src/api/elements';
import { fileColors } from '../../src/viewer/file_colors';
import { kMesh } from '../sample';

/** The red of each corner of each triangle, linear. */
function reds(colours: MeshColours | null): number[] {
    const attribute = fileColors({ ...kMesh, colours });
    return attribute ? Array.from({ length: attribute.count }, (_, at) => attribute.getX(at)) : [];
}

/** Colours whose red alone differs. */
function colours(of: MeshColours['of'], values: number[]): MeshColours {
    return { of, values: values.flatMap((red) => [red, 0, 0]) };
}

describe('the colours of a file', () => {
    it('are those of each corner, whatever they are given for', () => {
        const corners = [0, 255, 255, 0, 255, 0, 0, 255, 0, 255, 255, 0];
        const expected = corners.map((value) => value / 255);
        expect(reds(colours('corners', corners))).toEqual(expected);
        expect(reds(colours('vertices', [0, 255, 255, 0]))).toEqual(expected);
        expect(reds(colours('triangles', [255, 0, 0, 255]))).toEqual([
            1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1,
        ]);
        expect(reds(colours('model', [255]))).toEqual(Array(12).fill(1));
    });

    it('become light: half of what is written is a fifth of the light', () => {
        expect(reds(colours('model', [128]))[0]).toBeCloseTo(0.2159, 3);
    });

    it('are none where the file has none', () => {
        expect(fileColors({ ...kMesh, colours: null })).toBeNull();
    });
});
