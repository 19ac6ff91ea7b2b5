import {
    BufferAttribute,
    BufferGeometry,
    Color,
    DoubleSide,
    Group,
    Mesh,
    MeshBasicMaterial,
    MeshStandardMaterial,
    SphereGeometry,
} from 'three';
import { mergeVertices, toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js';

import type { PreviewMesh, SkeletonNode } from '../api/elements';
import type { Skeleton, Vector } from '../api/types';
import { disposeBelow } from './dispose';
import { fileColors } from './file_colors';
import { type Frame, frameModel, toUnit, unitPositions } from './frame';
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

function nodeRadius(node: SkeletonNode, frame: Frame): number {
    const scaled = kLeastNodeRadius + 0.12 * node.radius * frame.scale;
    return Math.min(kMostNodeRadius, Math.max(kLeastNodeRadius, scaled));
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
    private colored_: boolean;
    private theme_: ViewerTheme;

    constructor(input: ModelSceneInput, theme: ViewerTheme) {
        this.input_ = input;
        this.theme_ = theme;
        this.colored_ = this.hasColors;
        this.frame_ = frameModel(input.mesh, input.skeleton);
        this.addSurface(theme);
        this.addBranches(theme);
        this.addNodes(theme);
        this.root.add(this.surface_, this.nodes_);
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
                object.material = surfaceMaterial(this.theme_.surface, this.colored_);
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

    private addSurface(theme: ViewerTheme): void {
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
        const glass = new Mesh(geometry, surfaceMaterial(theme.surface, this.colored_));
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
        for (const node of this.input_.skeleton.nodes) {
            const mesh = new Mesh(ball, material);
            mesh.position.set(...toUnit(this.frame_, node.position));
            mesh.scale.setScalar(nodeRadius(node, this.frame_));
            this.nodes_.add(mesh);
        }
    }
}
