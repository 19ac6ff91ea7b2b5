import { Bone, type BufferGeometry, type Object3D, SkinnedMesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

import type { Vector } from '../api/types';

/** A model that moves with its bones, as the server's glTF says. */
export interface Rig {
    /** Holds the bones, in the file's frame. */
    root: Object3D;
    /** From where the vertices are counted, in the file's frame. */
    origin: Vector;
    /** By the number of the part. */
    parts: SkinnedMesh<BufferGeometry>[];
    /** Parents before children; the first holds all others. */
    bones: Bone[];
}

/** The loader makes names fit for its own paths, and keeps the file's beside them. */
function nameOf(object: Object3D): string {
    const { name } = object.userData;
    return typeof name === 'string' ? name : object.name;
}

/** The branch of the skeleton that turns with a bone; null for the root and the tips. */
export function branchOf(bone: Bone): number | null {
    const found = /^branch (\d+)$/.exec(nameOf(bone))?.[1];
    return found === undefined ? null : Number(found);
}

function partOf(mesh: SkinnedMesh): number {
    const material = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
    return Number(/^part (\d+)$/.exec(material?.name ?? '')?.[1] ?? 0);
}

/** Where the bones at rest take the vertices' zero; numbers of three.js' matrices are doubles. */
function originOf(mesh: SkinnedMesh | undefined): Vector {
    const [bone] = mesh?.skeleton.bones ?? [];
    const [inverse] = mesh?.skeleton.boneInverses ?? [];
    return bone && inverse
        ? new Vector3().applyMatrix4(inverse).applyMatrix4(bone.matrixWorld).toArray()
        : [0, 0, 0];
}

export async function loadRig(file: ArrayBuffer): Promise<Rig> {
    const { scene } = await new GLTFLoader().parseAsync(file, '');
    const parts: SkinnedMesh[] = [];
    const bones: Bone[] = [];
    scene.traverse((object) => {
        if (object instanceof SkinnedMesh) {
            parts.push(object);
        } else if (object instanceof Bone) {
            bones.push(object);
        }
    });
    parts.sort((a, b) => partOf(a) - partOf(b));
    scene.updateMatrixWorld(true);
    return { root: scene, origin: originOf(parts[0]), parts, bones };
}
