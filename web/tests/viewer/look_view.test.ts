import { LineSegments, Plane, Raycaster, Vector3 } from 'three';
import { expect, it, vi } from 'vitest';

import { lookView } from '../../src/viewer/look_view';
import { Measure } from '../../src/viewer/measure';
import { ModelScene, nodeRadius } from '../../src/viewer/model_scene';
import { cameraPosition, kFirstOrbit, standardView } from '../../src/viewer/orbit';
import { distanceColor, kFarShare, layingOver } from '../../src/viewer/overlay';
import { atOnce } from '../../src/viewer/slices';
import { oklab } from '../../src/viewer/part_colors';
import { readViewerTheme } from '../../src/viewer/theme';
import { kMesh, kSkeleton } from '../sample';

function scene(): ModelScene {
    return new ModelScene(
        { mesh: kMesh, skeleton: kSkeleton, branchColors: new Map() },
        readViewerTheme(),
    );
}

function lineCount(model: ModelScene): number {
    let count = 0;
    model.root.traverse((object) => {
        if (object instanceof LineSegments && object.parent?.visible) {
            count += object.geometry.getAttribute('position').count / 2;
        }
    });
    return count;
}

it('lists the branches with length and chain code, the longest first, and finds by them', () => {
    const onFind = vi.fn();
    const model = { name: 'a', mesh: kMesh, skeleton: kSkeleton, up: 'y', unit: 'mm' } as const;
    const view = lookView({ model, about: null, onFind });
    const rows = [...view.node.querySelectorAll('.branch-table tbody tr')];
    expect(rows.map((row) => row.textContent)).toEqual(['13 mm000Find', '21 mm0Find']);
    rows[1]?.querySelector('button')?.click();
    expect(onFind).toHaveBeenCalledExactlyOnceWith(kSkeleton.branches[1]);
    view.dispose();
});

it('sizes nodes by their significance', () => {
    const node = (significance: number) => ({ ...kSkeleton.nodes[0], significance }) as never;
    const radii = [0, 1, 4].map((each) => nodeRadius(node(each), 4));
    expect(radii).toEqual([...radii].sort((a, b) => a - b));
    expect(new Set(radii).size).toBe(3);
    expect(nodeRadius(node(3), 0)).toBe(radii[0]);
});

it('draws the edges of its triangles and its box only when asked to', () => {
    const model = scene();
    expect(lineCount(model)).toBe(0);
    model.wireframe = true;
    expect(lineCount(model)).toBe(6);
    model.boxed = true;
    expect(lineCount(model)).toBe(18);
    model.wireframe = false;
    expect(lineCount(model)).toBe(12);
    model.dispose();
});

it('keeps a cut and an opacity when its colours change', () => {
    const model = scene();
    const plane = new Plane(new Vector3(1, 0, 0), 0);
    model.section = plane;
    model.opacity = 0.9;
    model.applyTheme(readViewerTheme());
    const glass: unknown[] = [];
    model.root.traverse((object) => {
        if (object.userData.glass === true) {
            const { material } = object as never as {
                material: { clippingPlanes: unknown; uniforms: Record<string, { value: unknown }> };
            };
            glass.push(material.clippingPlanes, material.uniforms.body_opacity?.value);
        }
    });
    expect(glass).toEqual([[plane], 0.9]);
    model.dispose();
});

it('measures in the unit of the file, whatever the size on the screen', () => {
    const model = scene();
    model.root.updateMatrixWorld(true);
    const hit = (x: number, y: number): Vector3 => {
        const ray = new Raycaster(new Vector3(x, y, 5), new Vector3(0, 0, -1));
        return model.surfacePoint(ray) as Vector3;
    };
    const measure = new Measure('#ffffff');
    measure.add(hit(-0.6, -0.25));
    expect(measure.length).toBeNull();
    measure.add(hit(-0.1, -0.25));
    const length = (measure.length as number) * model.unitLength;
    // A unit in the scene is the radius of the model's sphere: half the diagonal of 3 by 1 by 1.
    expect(length).toBeGreaterThan(0.5 * model.unitLength - 1e-6);
    expect(model.unitLength).toBeCloseTo(Math.hypot(3, 1, 1) / 2, 6);
    measure.add(hit(-0.6, -0.25));
    expect(measure.count).toBe(1);
    expect(
        model.surfacePoint(new Raycaster(new Vector3(9, 9, 9), new Vector3(0, 0, -1))),
    ).toBeNull();
    measure.dispose();
    model.dispose();
});

it('looks from where drawings look', () => {
    const from = (name: Parameters<typeof standardView>[0]) =>
        cameraPosition(standardView(name, kFirstOrbit)).map((each) => Math.round(each) + 0);
    expect(from('Front')).toEqual([0, 0, 3]);
    expect(from('Right')).toEqual([3, 0, 0]);
    expect(from('Left')).toEqual([-3, 0, 0]);
    expect(from('Back')).toEqual([0, 0, -3]);
    expect(from('Top')).toEqual([0, 3, 0]);
    expect(from('Bottom')).toEqual([0, -3, 0]);
});

it('lays a model over itself without a gap, and colours what is farther lighter', () => {
    const [query, hit] = [scene(), scene()];
    const { most, mean, distances } = atOnce(
        layingOver(query, hit, {
            nodes: [],
            branches: [],
            cluster_sizes: [],
        }),
    );
    expect(most).toBeLessThan(1e-4);
    expect(mean).toBeLessThanOrEqual(most);
    expect(distances).toHaveLength(12);
    const lightness = [0, 0.5, 1, 3].map((share) => oklab(distanceColor(share * kFarShare))[0]);
    expect(lightness[1]).toBeGreaterThan(lightness[0] as number);
    expect(lightness[2]).toBeGreaterThan(lightness[1] as number);
    expect(lightness[3]).toBe(lightness[2]);
    query.dispose();
    hit.dispose();
});
