import { BufferAttribute, Color, SRGBColorSpace } from 'three';

import type { MeshColours, PreviewMesh } from '../api/elements';

/** Which of a mesh's colours the corner of a triangle has; corners are counted through. */
function colorOfCorner({ of }: MeshColours, mesh: PreviewMesh, corner: number): number {
    switch (of) {
        case 'model':
            return 0;
        case 'vertices':
            return mesh.triangles[corner] ?? 0;
        case 'triangles':
            return Math.floor(corner / 3);
        case 'corners':
            return corner;
    }
}

/**
 * The colours that a model's file gives it as an attribute of a geometry without an index, three
 * vertices a triangle: linear, as three.js computes. Null: the file has none.
 */
export function fileColors(mesh: PreviewMesh): BufferAttribute | null {
    const { colours } = mesh;
    if (!colours) {
        return null;
    }
    const linear = new Float32Array(3 * mesh.triangles.length);
    const color = new Color();
    for (let corner = 0; corner < mesh.triangles.length; corner++) {
        const at = 3 * colorOfCorner(colours, mesh, corner);
        const [red = 0, green = 0, blue = 0] = colours.values.slice(at, at + 3);
        color
            .setRGB(red / 255, green / 255, blue / 255, SRGBColorSpace)
            .toArray(linear, 3 * corner);
    }
    return new BufferAttribute(linear, 3);
}
