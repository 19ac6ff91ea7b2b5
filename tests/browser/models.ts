import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

type Corner = readonly [number, number, number];

interface Box {
    low: Corner;
    high: Corner;
}

/** A closed box; boxes that overlap are one solid to the voxelization. */
export function box(low: Corner, high: Corner): Box {
    return { low, high };
}

function limb(x: number, z: number, height: number, thickness: number): Box {
    const half = thickness / 2;
    return box([x - half, 0, z - half], [x + half, height, z + half]);
}

/** Four legs, a trunk and a raised head. */
function quadruped(length: number, height: number): Box[] {
    const legs = [0.1 * length, 0.9 * length].flatMap((x) =>
        [0.2, 0.8].map((z) => limb(x, z, height, 0.22)),
    );
    return [
        ...legs,
        box([0, height - 0.1, 0.05], [length, height + 0.5, 0.95]),
        box([length - 0.25, height + 0.2, 0.35], [length + 0.9, height + 0.5, 0.65]),
        box([length + 0.6, height + 0.2, 0.35], [length + 0.9, height + 1.1, 0.65]),
    ];
}

/** Two arms across a pole. */
function cross(length: number, height: number): Box[] {
    const middle = length / 2;
    return [
        box([middle - 0.15, 0, -0.15], [middle + 0.15, 1.5 * height, 0.15]),
        box([0, height - 0.15, -0.15], [length, height + 0.15, 0.15]),
    ];
}

/** A bar that is bent once. */
function angle(length: number, height: number): Box[] {
    return [box([0, 0, -0.2], [length, 0.4, 0.2]), box([0, 0, -0.2], [0.4, height, 0.2])];
}

const kFaces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
];

/** @param color of each face, as OFF files have it; none where it is empty */
export function off(boxes: readonly Box[], color = ''): string {
    const vertices: string[] = [];
    const faces: string[] = [];
    for (const { low, high } of boxes) {
        const first = vertices.length;
        for (let corner = 0; corner < 8; corner++) {
            const at = [0, 1, 2].map((axis) =>
                ((corner >> axis) & 1 ? high[axis] : low[axis])?.toFixed(4),
            );
            vertices.push(at.join(' '));
        }
        for (const face of kFaces) {
            faces.push(`4 ${face.map((corner) => first + corner).join(' ')} ${color}`);
        }
    }
    return `OFF\n${vertices.length} ${faces.length} 0\n${[...vertices, ...faces].join('\n')}\n`;
}

const kShapes = { angle, cross, quadruped };

export const kClasses = Object.keys(kShapes);
export const kModelsPerClass = 4;

export interface WrittenModels {
    folder: string;
    classes: string;
    /** Not in the folder: a quadruped of other proportions. */
    query: string;
    truncated: string;
    /** The same as `query`, red all over. */
    painted: string;
}

/** A small collection of three classes, and what the tests upload, below `folder`. */
export function writeModels(folder: string): WrittenModels {
    const written: WrittenModels = {
        folder: join(folder, 'models'),
        classes: join(folder, 'classes.cla'),
        query: join(folder, 'query.off'),
        truncated: join(folder, 'truncated.off'),
        painted: join(folder, 'painted.off'),
    };
    mkdirSync(written.folder);
    const lines = ['PSB 1', `${kClasses.length} ${kClasses.length * kModelsPerClass}`, ''];
    let id = 0;
    for (const [name, shape] of Object.entries(kShapes)) {
        lines.push(`${name} 0 ${kModelsPerClass}`);
        for (let at = 0; at < kModelsPerClass; at++) {
            id += 1;
            lines.push(String(id));
            const text = off(shape(2.2 + 0.25 * at, 1.3 + 0.2 * (at % 3)));
            writeFileSync(join(written.folder, `${id}.off`), text);
        }
        lines.push('');
    }
    writeFileSync(written.classes, lines.join('\n'));
    const query = off(quadruped(2.5, 1.6));
    // One that cannot be indexed, and says so to whoever keeps the collection.
    writeFileSync(join(written.folder, 'broken.off'), 'OFF\n3 1 0\n0 0 0\n');
    writeFileSync(written.query, query);
    writeFileSync(written.painted, off(quadruped(2.5, 1.6), '255 0 0'));
    writeFileSync(written.truncated, query.slice(0, Math.floor(0.6 * query.length)));
    return written;
}
