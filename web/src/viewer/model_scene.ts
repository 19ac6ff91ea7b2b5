import {
    BufferAttribute,
    BufferGeometry,
    Color,
    DoubleSide,
    Group,
    type Material,
    Mesh,
    MeshBasicMaterial,
    MeshStandardMaterial,
    type Plane,
    type Raycaster,
    type ShaderMaterial,
    SphereGeometry,
    Vector3,
} from 'three';
import { mergeVertices, toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js';

import type { PreviewMesh, SkeletonNode } from '../api/elements';
import type { Skeleton, Vector } from '../api/types';
import { disposeBelow } from './dispose';
import { fileColors } from './file_colors';
import { type Frame, frameModel, toUnit, unitPositions } from './frame';
import { boxLines, wireLines } from './outlines';
import { surfaceMaterial } from './surface_material';
import type { ViewerTheme } from './theme';
import { buildTube } from './tube';

/** In radii of the model's bounding sphere, so that a mouse and a tower look alike. */
const kTubeRadius = 0.017;
const kHighlightedTubeScale = 1.7;
const kLeastNodeRadius = 0.024;
const kMostNodeRadius = 0.05;
const kGlow = 0.12;
const kCreaseAngle = Math.PI / 4.5;
/** In the unit sphere. */
const kWeldTolerance = 1e-5;

export interface ModelSceneInput {
    /** Null: the skeleton alone. */
    mesh: PreviewMesh | null;
    skeleton: Skeleton;
    /** `#rrggbb` by the id of a branch; branches that are not in it are drawn as unmatched. */
    branchColors: ReadonlyMap<number, string>;
}

type Solid = Mesh<BufferGeometry, MeshStandardMaterial>;

interface BranchTube {
    solid: Solid;
    line: Vector[];
    /** The radius that the geometry was made with; 0: not yet. */
    radius: number;
}

function creasedSurface(mesh: PreviewMesh, frame: Frame): BufferGeometry {
    const soup = new BufferGeometry();
    soup.setAttribute('position', new BufferAttribute(unitPositions(frame, mesh), 3));
    soup.setIndex(mesh.triangles);
    const welded = mergeVertices(soup, kWeldTolerance);
    // Three vertices a triangle, in the triangles' order.
    const creased = toCreasedNormals(welded, kCreaseAngle);
    const colors = fileColors(mesh);
    if (colors) {
        creased.setAttribute('color', colors);
    }
    soup.dispose();
    welded.dispose();
    return creased;
}

/** By its significance (eq. 3.3 of the thesis), as a share of the most significant node's. */
export function nodeRadius({ significance }: SkeletonNode, most: number): number {
    const share = most > 0 ? Math.min(1, Math.max(0, significance / most)) : 0;
    return kLeastNodeRadius + (kMostNodeRadius - kLeastNodeRadius) * Math.sqrt(share);
}

/**
 * One model as a tree of three.js objects in the unit sphere: a glassy surface, a tube for each
 * branch, a ball for each node. Owns its geometries and materials until {@link dispose}.
 */
export class ModelScene {
    readonly root = new Group();
    private readonly surface_ = new Group();
    private readonly nodes_ = new Group();
    private readonly tubes_ = new Map<number, BranchTube>();
    private readonly input_: ModelSceneInput;
    private readonly frame_: Frame;
    private highlighted_: number | null = null;
    private readonly wires_ = new Group();
    private readonly box_ = new Group();
    private colored_: boolean;
    private opacity_: number | null = null;
    private section_: Plane | null = null;
    private theme_: ViewerTheme;

    constructor(input: ModelSceneInput, theme: ViewerTheme) {
        this.input_ = input;
        this.theme_ = theme;
        this.colored_ = this.hasColors;
        this.frame_ = frameModel(input.mesh, input.skeleton);
        this.addSurface();
        this.addBranches(theme);
        this.addNodes(theme);
        this.root.add(this.surface_, this.nodes_, this.wires_, this.box_);
    }

    /** The branches' polylines in the unit sphere. */
    get branchLines(): { id: number; points: Vector[] }[] {
        return [...this.tubes_].map(([id, { line }]) => ({ id, points: line }));
    }

    set surfaceVisible(visible: boolean) {
        this.surface_.visible = visible;
    }

    set nodesVisible(visible: boolean) {
        this.nodes_.visible = visible;
    }

    /** From glass, 0, to solid, 1; null: as the page's style has it. */
    set opacity(opacity: number | null) {
        this.opacity_ = opacity;
        this.paintSurface();
    }

    /** The edges of the triangles. */
    set wireframe(shown: boolean) {
        const { mesh } = this.input_;
        if (shown && mesh && this.wires_.children.length === 0) {
            const positions = unitPositions(this.frame_, mesh);
            this.wires_.add(wireLines(positions, mesh.triangles, this.theme_.surface.rim));
        }
        this.wires_.visible = shown;
    }

    /** The box along the axes of the file. */
    set boxed(shown: boolean) {
        const bounds = this.input_.mesh?.bounds;
        if (shown && bounds && this.box_.children.length === 0) {
            const [min, max] = [bounds.min, bounds.max].map(
                (corner) => new Vector3(...toUnit(this.frame_, corner)),
            ) as [Vector3, Vector3];
            this.box_.add(boxLines(min, max, this.theme_.node));
        }
        this.box_.visible = shown;
    }

    /** Length in the model's unit of one in the scene. */
    get unitLength(): number {
        return 1 / this.frame_.scale;
    }

    /** Where a ray meets the surface first, in the frame of `root`. */
    surfacePoint(ray: Raycaster): Vector3 | null {
        const [hit] = ray.intersectObjects(
            this.surface_.children.filter(({ userData }) => userData.glass === true),
            false,
        );
        return hit ? this.root.worldToLocal(hit.point.clone()) : null;
    }

    /** Corners of the triangles in the frame of `root`, three numbers each. */
    get corners(): Float32Array {
        const { mesh } = this.input_;
        if (!mesh) {
            return new Float32Array();
        }
        const positions = unitPositions(this.frame_, mesh);
        const corners = new Float32Array(3 * mesh.triangles.length);
        for (const [at, vertex] of mesh.triangles.entries()) {
            corners.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * at);
        }
        return corners;
    }

    /** Where a node of the skeleton is in the frame of `root`; null: there is no such node. */
    nodePosition(id: number): Vector3 | null {
        const node = this.input_.skeleton.nodes.find((each) => each.id === id);
        return node ? new Vector3(...toUnit(this.frame_, node.position)) : null;
    }

    /** Whether the model's file gives it colours. */
    get hasColors(): boolean {
        return this.input_.mesh?.colours != null;
    }

    /** Whether the surface is shown in them; from the start where there are any. */
    set colored(colored: boolean) {
        this.colored_ = colored && this.hasColors;
        this.paintSurface();
    }

    /** Thickens one branch and lets the others step back; null ends it. */
    highlight(branch: number | null): void {
        this.highlighted_ = branch !== null && this.tubes_.has(branch) ? branch : null;
        for (const [id, tube] of this.tubes_) {
            const chosen = id === this.highlighted_;
            const faded = this.highlighted_ !== null && !chosen;
            const { material } = tube.solid;
            material.opacity = faded ? 0.28 : 1;
            material.transparent = faded;
            material.emissiveIntensity = chosen ? 0.55 : kGlow;
            this.shapeTube(tube, this.tubeRadius(id) * (chosen ? kHighlightedTubeScale : 1));
        }
    }

    applyTheme(theme: ViewerTheme): void {
        this.theme_ = theme;
        this.paintSurface();
        for (const [id, tube] of this.tubes_) {
            this.paint(tube.solid.material, this.input_.branchColors.get(id) ?? theme.unmatched);
        }
        this.nodes_.traverse((object) => {
            if (object instanceof Mesh) {
                this.paint(object.material, theme.node);
            }
        });
    }

    dispose(): void {
        disposeBelow(this.root);
        this.tubes_.clear();
    }

    private paintSurface(): void {
        this.surface_.traverse((object) => {
            if (object instanceof Mesh && object.userData.glass === true) {
                object.material.dispose();
                object.material = this.glass();
            }
        });
    }

    private paint(material: MeshStandardMaterial, color: string): void {
        material.color = new Color(color);
        material.emissive = new Color(color);
    }

    private material(color: string): MeshStandardMaterial {
        const material = new MeshStandardMaterial({ roughness: 0.55, emissiveIntensity: kGlow });
        this.paint(material, color);
        return material;
    }

    /** Cuts away what lies before a plane of the scene; null: nothing. */
    set section(plane: Plane | null) {
        this.section_ = plane;
        for (const group of [this.surface_, this.wires_]) {
            for (const child of group.children) {
                ((child as Mesh).material as Material).clippingPlanes = plane ? [plane] : null;
            }
        }
    }

    private glass(): ShaderMaterial {
        const { surface } = this.theme_;
        const given = this.opacity_;
        const material = surfaceMaterial(
            given === null
                ? surface
                : {
                      ...surface,
                      bodyOpacity: given,
                      rimOpacity: Math.max(given, surface.rimOpacity),
                  },
            this.colored_,
            given,
        );
        material.clippingPlanes = this.section_ ? [this.section_] : null;
        return material;
    }

    private addSurface(): void {
        const { mesh } = this.input_;
        if (!mesh || mesh.triangles.length === 0) {
            return;
        }
        const geometry = creasedSurface(mesh, this.frame_);
        // First the depth of the nearest surface alone, so that only that one is tinted: with all
        // layers blended, folded limbs grew darker than the torso in front of them.
        const depth = new Mesh(
            geometry,
            new MeshBasicMaterial({ colorWrite: false, side: DoubleSide, transparent: true }),
        );
        depth.renderOrder = 1;
        const glass = new Mesh(geometry, this.glass());
        glass.renderOrder = 2;
        glass.userData.glass = true;
        this.surface_.add(depth, glass);
    }

    private addBranches(theme: ViewerTheme): void {
        for (const branch of this.input_.skeleton.branches) {
            const color = this.input_.branchColors.get(branch.id) ?? theme.unmatched;
            const tube: BranchTube = {
                solid: new Mesh(new BufferGeometry(), this.material(color)),
                line: branch.points.map((point) => toUnit(this.frame_, point)),
                radius: 0,
            };
            this.shapeTube(tube, this.tubeRadius(branch.id));
            this.tubes_.set(branch.id, tube);
            this.root.add(tube.solid);
        }
    }

    private tubeRadius(id: number): number {
        return kTubeRadius * (this.input_.branchColors.has(id) ? 1 : 0.6);
    }

    private shapeTube(tube: BranchTube, radius: number): void {
        if (tube.radius === radius) {
            return;
        }
        const { positions, normals, indices } = buildTube(tube.line, radius);
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', new BufferAttribute(positions, 3));
        geometry.setAttribute('normal', new BufferAttribute(normals, 3));
        geometry.setIndex(new BufferAttribute(indices, 1));
        tube.solid.geometry.dispose();
        tube.solid.geometry = geometry;
        tube.radius = radius;
    }

    private addNodes(theme: ViewerTheme): void {
        const ball = new SphereGeometry(1, 20, 14);
        const material = this.material(theme.node);
        const { nodes } = this.input_.skeleton;
        const most = Math.max(0, ...nodes.map(({ significance }) => significance));
        for (const node of nodes) {
            const mesh = new Mesh(ball, material);
            mesh.position.set(...toUnit(this.frame_, node.position));
            mesh.scale.setScalar(nodeRadius(node, most));
            this.nodes_.add(mesh);
        }
    }
}
