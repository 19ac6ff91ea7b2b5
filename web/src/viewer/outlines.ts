import {
    BufferAttribute,
    BufferGeometry,
    LineBasicMaterial,
    LineSegments,
    type Vector3,
    WireframeGeometry,
} from 'three';

function lines(geometry: BufferGeometry, color: string, opacity: number): LineSegments {
    const material = new LineBasicMaterial({ color, opacity, transparent: true });
    const node = new LineSegments(geometry, material);
    // After the surface, which is drawn in two passes.
    node.renderOrder = 3;
    return node;
}

/** The edges of triangles, each once. */
export function wireLines(
    positions: Float32Array,
    triangles: readonly number[],
    color: string,
): LineSegments {
    const solid = new BufferGeometry();
    solid.setAttribute('position', new BufferAttribute(positions, 3));
    solid.setIndex([...triangles]);
    const wires = new WireframeGeometry(solid);
    solid.dispose();
    return lines(wires, color, 0.5);
}

/** The twelve edges of a box. */
export function boxLines(min: Vector3, max: Vector3, color: string): LineSegments {
    const ends: number[] = [];
    const corner = (at: number): number[] =>
        [0, 1, 2].map((axis) => ((at >> axis) & 1 ? max : min).getComponent(axis));
    for (let from = 0; from < 8; from++) {
        for (const axis of [0, 1, 2]) {
            if (!((from >> axis) & 1)) {
                ends.push(...corner(from), ...corner(from | (1 << axis)));
            }
        }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(ends), 3));
    return lines(geometry, color, 0.7);
}
