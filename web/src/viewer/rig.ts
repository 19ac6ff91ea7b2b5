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

/** A number that the file says of one of its things. */
function extra(userData: Record<string, unknown>, name: string): number | null {
    const value = userData[name];
    return typeof value === 'number' ? value : null;
}

/** The branch of the skeleton that turns with a bone; null for the root and the tips. */
export function branchOf(bone: Bone): number | null {
    return extra(bone.userData, 'branch');
}

function partOf(mesh: SkinnedMesh): number {
    const material = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
    return extra(material?.userData ?? {}, 'part') ?? 0;
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
