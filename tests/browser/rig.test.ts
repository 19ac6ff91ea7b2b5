import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { validateBytes } from 'gltf-validator';
import { afterAll, beforeAll, expect, it } from 'vitest';

import { writeModels } from './models';
import { buildIndex, startServer, writeRig } from './server';

let folder: string;

beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'ossuary-rig-'));
});

afterAll(() => {
    rmSync(folder, { recursive: true, force: true });
});

type Point = readonly number[];

function off(points: readonly Point[], triangles: readonly Point[]): string {
    const lines = [...points.map((point) => point.join(' '))];
    lines.push(...triangles.map((corners) => `3 ${corners.join(' ')}`));
    return `OFF\n${points.length} ${triangles.length} 0\n${lines.join('\n')}\n`;
}

/** A closed surface over a grid that is joined at its ends in both directions. */
function ring(around: number, across: number, at: (u: number, v: number) => Point): string {
    const points: Point[] = [];
    const triangles: Point[] = [];
    for (let i = 0; i < around; i++) {
        for (let j = 0; j < across; j++) {
            points.push(at((2 * Math.PI * i) / around, (2 * Math.PI * j) / across));
            const corner = (a: number, b: number) => (a % around) * across + (b % across);
            const [a, b] = [corner(i, j), corner(i + 1, j)];
            const [c, d] = [corner(i + 1, j + 1), corner(i, j + 1)];
            triangles.push([a, b, c], [a, c, d]);
        }
    }
    return off(points, triangles);
}

const kTetrahedron: [Point[], Point[]] = [
    [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
    ],
    [
        [0, 2, 1],
        [0, 1, 3],
        [0, 3, 2],
        [1, 2, 3],
    ],
];

const kShapes: Readonly<Record<string, string>> = {
    tetrahedron: off(...kTetrahedron),
    'open tetrahedron': off(kTetrahedron[0], kTetrahedron[1].slice(1)),
    'tetrahedron with collapsed faces': off(kTetrahedron[0], [
        ...kTetrahedron[1],
        [0, 0, 1],
        [2, 2, 2],
    ]),
    'tetrahedron with unused vertices': off(
        [...kTetrahedron[0], [9, 9, 9], [0, 0, 0]],
        kTetrahedron[1],
    ),
    ring: ring(48, 16, (u, v) => [
        (3 + 0.6 * Math.cos(v)) * Math.cos(u),
        (3 + 0.6 * Math.cos(v)) * Math.sin(u),
        0.6 * Math.sin(v),
    ]),
    'ring far from the origin and small': ring(48, 16, (u, v) => [
        1000 + 1e-3 * (3 + 0.6 * Math.cos(v)) * Math.cos(u),
        1e-3 * (3 + 0.6 * Math.cos(v)) * Math.sin(u),
        1e-3 * 0.6 * Math.sin(v),
    ]),
};

/** Errors and warnings as text; empty where the file is fine. */
async function complaints(file: Uint8Array): Promise<string[]> {
    const { issues, info } = await validateBytes(file);
    expect(info.hasSkins).toBe(true);
    expect(info.totalTriangleCount).toBeGreaterThan(0);
    const found = issues.messages.filter(({ severity }) => severity <= 1);
    expect(found.length).toBe(issues.numErrors + issues.numWarnings);
    return found.map(({ code, message, pointer }) => `${pointer}: ${code}: ${message}`);
}

it('would notice a broken rig', async () => {
    const model = join(folder, 'whole.off');
    writeFileSync(model, kShapes.ring ?? '');
    writeRig(model, join(folder, 'whole.glb'));
    const file = readFileSync(join(folder, 'whole.glb'));
    // The last bytes are inverse bind matrices, whose last row has to be 0 0 0 1.
    file.writeFloatLE(7, file.length - 4);
    expect(await complaints(file)).not.toEqual([]);
});

it.each(Object.keys(kShapes))('a %s is rigged without errors or warnings', async (name) => {
    const model = join(folder, 'model.off');
    const glb = join(folder, 'model.glb');
    writeFileSync(model, kShapes[name] ?? '');
    writeRig(model, glb);
    expect(await complaints(readFileSync(glb))).toEqual([]);
});

it('the server rigs every model of its collection without errors or warnings', async () => {
    const models = writeModels(folder);
    const index = join(folder, 'collection.ossuary');
    buildIndex(index, models.folder, models.classes);
    const server = await startServer(index);
    try {
        const list = (await (await fetch(`${server.origin}/v1/models`)).json()) as {
            models: { id: number }[];
        };
        expect(list.models.length).toBeGreaterThan(0);
        for (const { id } of list.models) {
            const answer = await fetch(`${server.origin}/v1/models/${id}/rig.glb`);
            expect(answer.status).toBe(200);
            expect(await complaints(new Uint8Array(await answer.arrayBuffer()))).toEqual([]);
        }
    } finally {
        await server.stop();
    }
});
