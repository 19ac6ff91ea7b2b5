#!/usr/bin/env bash
# glTF-Transform 4.5.1: weld() leaves the seam of a mirrored model open, because a mirrored 0 is -0.
#
# Expected: both halves of a symmetric model meet in vertices of equal coordinates; weld() makes one vertex of each pair and
#   the surface is closed. Its manual says that it merges "bitwise identical" vertices, which one reads as "no tolerance".
# Seen: mirroring multiplies by -1, so every coordinate on the plane of symmetry becomes -0, which equals 0 in every
#   comparison but differs in one bit. A box made of a half and its mirror image keeps 16 vertices and 8 open edges. With 0
#   added to each coordinate first (-0 + 0 = 0) the same box has 12 vertices and no open edge. meshoptimizer 1.3.0, whose
#   simplifier usually gets the welded mesh, takes both zeros for one position, so two steps of one pipeline disagree.
# Matters: mirrored halves are how people, animals, cars and furniture are modelled. The crack is invisible, has no width and
#   survives the file; it splits the graph of edges (geodesic distances, segmentation), and a test for closedness fails.
# Needs: node 18 or later, npm. Exit 0: as stated. 1: changed. 2: not to be had.
set -euo pipefail
for tool in node npm; do
    command -v "$tool" > /dev/null || { echo "$tool is missing" >&2; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

export npm_config_cache=$work/cache npm_config_update_notifier=false
echo '{"private": true, "type": "module"}' > package.json
npm install --silent --no-audit --no-fund @gltf-transform/core@4.5.1 @gltf-transform/functions@4.5.1 meshoptimizer@1.3.0 \
    > /dev/null 2>&1 || { echo "glTF-Transform 4.5.1 or meshoptimizer 1.3.0 is not available (any more)" >&2; exit 2; }

cat > weld.js << 'JAVASCRIPT'
import { Document, Logger } from '@gltf-transform/core';
import { weld } from '@gltf-transform/functions';
import { MeshoptSimplifier } from 'meshoptimizer';

// The right half of a box: eight corners, five faces, open at x = 0.
const corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
const quads = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [1, 2, 6, 5]];
const half = quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
const mirrored = corners.map(([x, y, z]) => [-1 * x, y, z]);

function openEdges(indices) {
    const uses = new Map();
    for (let i = 0; i < indices.length; i++) {
        const next = i % 3 === 2 ? i - 2 : i + 1;
        const edge = [indices[i], indices[next]].sort((a, b) => a - b).join();
        uses.set(edge, (uses.get(edge) ?? 0) + 1);
    }
    return [...uses.values()].filter((n) => n === 1).length;
}

async function welded(positions) {
    const document = new Document().setLogger(new Logger(Logger.Verbosity.ERROR));
    const buffer = document.createBuffer();
    const indices = [...half, ...half.map((i) => i + 8).reverse()];
    const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
    const primitive = document.createPrimitive()
        .setAttribute('POSITION', accessor('VEC3', new Float32Array(positions.flat())))
        .setIndices(accessor('SCALAR', new Uint16Array(indices)));
    document.createMesh().addPrimitive(primitive);
    await document.transform(weld());
    return [primitive.getAttribute('POSITION').getCount(), openEdges([...primitive.getIndices().getArray()])];
}

await MeshoptSimplifier.ready;
const both = [...corners, ...mirrored];
const asMade = await welded(both);
const plusZero = await welded(both.map((p) => p.map((x) => x + 0)));
const remap = MeshoptSimplifier.generatePositionRemap(new Float32Array(both.flat()), 3);
const positions = new Set(remap).size;
console.log(`glTF-Transform, as mirrored:  ${asMade[0]} vertices, ${asMade[1]} open edges`);
console.log(`glTF-Transform, 0 added:      ${plusZero[0]} vertices, ${plusZero[1]} open edges`);
console.log(`meshoptimizer, as mirrored:   ${positions} positions`);
process.exit(`${asMade} ${plusZero} ${positions}` === '16,8 12,0 12' ? 0 : 1);
JAVASCRIPT
node weld.js || { echo "changed: no longer as stated above" >&2; exit 1; }
