import type { Segments, Vector } from '../src/api/types';

/**
 * A rigged model as the server writes it: two triangles along x, each a part with a bone of its
 * own, branch 1 hanging on branch 0.
 */

const kPositions = [
    [0, 0, 0, 1, 0, 0, 0, 0.2, 0],
    [1, 0, 0, 2, 0, 0, 1, 0.2, 0],
];

export const kSegments: Segments = {
    parts: [
        {
            part: 0,
            colour: '#aa0000',
            triangles: 1,
            area: 3,
            area_share: 0.75,
            branch: 0,
            neighbors: [1],
        },
        {
            part: 1,
            colour: '#00aa00',
            triangles: 1,
            area: 1,
            area_share: 0.25,
            branch: 1,
            neighbors: [0],
        },
    ],
    labels: [0, 1],
};

function bytesOf(view: ArrayBufferView): Uint8Array {
    return new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
}

export interface RigFileOptions {
    withBranches: boolean;
    /** The vertices' zero in the file's frame: the translation of a node above bones and mesh. */
    origin: Vector | null;
}

const kDefaults: RigFileOptions = { withBranches: true, origin: null };

/** The bones, and the mesh after them. */
function nodes(withBranches: boolean): object[] {
    const model = { name: 'model', mesh: 0, skin: 0 };
    return withBranches
        ? [
              { name: 'root', children: [1] },
              { name: 'branch 0', extras: { branch: 0 }, children: [2] },
              {
                  name: 'branch 1',
                  extras: { branch: 1 },
                  translation: [1, 0, 0],
                  children: [3],
              },
              { name: 'tip of branch 1', translation: [1, 0, 0] },
              model,
          ]
        : [{ name: 'root' }, model];
}

export function rigFile(options: Partial<RigFileOptions> = {}): ArrayBuffer {
    const { withBranches, origin } = { ...kDefaults, ...options };
    const views: object[] = [];
    const accessors: object[] = [];
    const chunks: Uint8Array[] = [];
    let length = 0;
    const add = (values: ArrayBufferView, componentType: number, type: string, count: number) => {
        const bytes = bytesOf(values);
        views.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
        const padded = new Uint8Array(Math.ceil(bytes.length / 4) * 4);
        padded.set(bytes);
        chunks.push(padded);
        length += padded.length;
        const bounds = type === 'VEC3' ? { min: [0, 0, 0], max: [2, 1, 1] } : {};
        accessors.push({ bufferView: views.length - 1, componentType, type, count, ...bounds });
        return accessors.length - 1;
    };
    const all = nodes(withBranches);
    const bones = all.length - 1;
    const primitives = kPositions.map((positions, part) => ({
        attributes: {
            POSITION: add(new Float32Array(positions), 5126, 'VEC3', 3),
            NORMAL: add(new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]), 5126, 'VEC3', 3),
            JOINTS_0: add(
                new Uint16Array([0, 1, 2].flatMap(() => [withBranches ? part + 1 : 0, 0, 0, 0])),
                5123,
                'VEC4',
                3,
            ),
            WEIGHTS_0: add(
                new Float32Array([0, 1, 2].flatMap(() => [1, 0, 0, 0])),
                5126,
                'VEC4',
                3,
            ),
        },
        indices: add(new Uint32Array([0, 1, 2]), 5125, 'SCALAR', 3),
        material: part,
    }));
    const binds = Array.from({ length: bones }, (_, bone) => {
        const along = -Math.max(0, bone - 1);
        return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, along, 0, 0, 1];
    });
    const inverseBindMatrices = add(new Float32Array(binds.flat()), 5126, 'MAT4', bones);
    const roots = [0, all.length - 1];
    const placed = origin ? [...all, { translation: origin, children: roots }] : all;
    const document = {
        asset: { version: '2.0' },
        buffers: [{ byteLength: length }],
        bufferViews: views,
        accessors,
        materials: [
            { name: 'part 0', extras: { part: 0 } },
            { name: 'part 1', extras: { part: 1 } },
        ],
        meshes: [{ primitives }],
        nodes: placed,
        skins: [
            { joints: all.slice(0, -1).map((_, bone) => bone), inverseBindMatrices, skeleton: 0 },
        ],
        scenes: [{ nodes: origin ? [all.length] : roots }],
        scene: 0,
    };
    const text = new TextEncoder().encode(JSON.stringify(document));
    const padded = new Uint8Array(Math.ceil(text.length / 4) * 4).fill(0x20);
    padded.set(text);
    const file = new Uint8Array(12 + 8 + padded.length + 8 + length);
    const words = new DataView(file.buffer);
    const header = [0x46546c67, 2, file.length, padded.length, 0x4e4f534a];
    for (const [at, word] of header.entries()) {
        words.setUint32(4 * at, word, true);
    }
    file.set(padded, 20);
    words.setUint32(20 + padded.length, length, true);
    words.setUint32(24 + padded.length, 0x004e4942, true);
    let at = 28 + padded.length;
    for (const chunk of chunks) {
        file.set(chunk, at);
        at += chunk.length;
    }
    return file.buffer;
}
