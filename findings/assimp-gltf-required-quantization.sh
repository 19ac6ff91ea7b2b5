#!/usr/bin/env bash
# assimp 5.2.5 (Debian 12) reads what glTF-Transform 4.5.1 quantizes "with success" and without one right coordinate.
#
# Expected: quantize() stores positions as 16-bit numbers and lists KHR_mesh_quantization under extensionsRequired, which in
#   glTF means: refuse this file if you do not know that. So an old reader fails with a message, and one can fall back.
# Seen: assimp does not look at extensionsRequired. It copies the six bytes of each position into the room for three floats,
#   so the first two numbers become one float, the third the low half of another, and the last is 0. A box of 1 x 2 x 3
#   becomes eight points with x beyond 1e12, y near 1e-40 and z = 0. Exit code 0, 12 faces, no warning;
#   `assimp info`, which validates what it has read, finds nothing either. The official validator has no fault to find in
#   the file, the same box in floats is read rightly, and glTF-Transform measures both alike.
# Matters: quantized files are what viewers on the web are given, often under the same name. A service that reads glTF by
#   assimp gets a mesh with the right counts and a finite bounding box whose shape is a line. Read extensionsRequired yourself.
# Needs: apt-get with a package list of Debian 12, dpkg, node 18 or later, npm. Exit 0: as stated. 1: changed. 2: not to be had.
set -euo pipefail
for tool in apt-get dpkg node npm; do
    command -v "$tool" > /dev/null || { echo "$tool is missing" >&2; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

debian() {
    apt-get -qq download "$@" > /dev/null 2>&1 || { echo "not all available (any more): $*" >&2; exit 2; }
    for archive in *.deb; do dpkg -x "$archive" root; done
}
debian assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1
LD_LIBRARY_PATH=$(echo "$work"/root/usr/lib/*-linux-gnu)
export LD_LIBRARY_PATH PATH=$work/root/usr/bin:$PATH
export npm_config_cache=$work/cache npm_config_update_notifier=false
echo '{"private": true, "type": "module"}' > package.json
npm install --silent --no-audit --no-fund @gltf-transform/{core,extensions,functions}@4.5.1 gltf-validator@2.0.0-dev.3.10 \
    > /dev/null 2>&1 || { echo "glTF-Transform 4.5.1 or gltf-validator 2.0.0-dev.3.10 is not available (any more)" >&2; exit 2; }

cat > quantize.js << 'JAVASCRIPT'
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { Document, Logger, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { getBounds, quantize } from '@gltf-transform/functions';
import validator from 'gltf-validator';

const signs = [-1, 1];
const positions = signs.flatMap((z) => signs.flatMap((y) => signs.map((x) => [x / 2, y, z * 1.5]))).flat();
const corners = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5];
const document = new Document().setLogger(new Logger(Logger.Verbosity.ERROR));
const buffer = document.createBuffer();
const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
const primitive = document.createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', new Float32Array(positions)))
    .setIndices(accessor('SCALAR', new Uint16Array(corners)));
const scene = document.createScene().addChild(document.createNode('box').setMesh(document.createMesh().addPrimitive(primitive)));

/** What the validator, glTF-Transform and assimp make of the document as it stands. */
async function look(name) {
    const bytes = await new NodeIO().registerExtensions(ALL_EXTENSIONS).writeBinary(document);
    writeFileSync(`${name}.glb`, bytes);
    const { issues } = await validator.validateBytes(bytes);
    execFileSync('assimp', ['info', `${name}.glb`]); // throws if the exit code is not 0
    execFileSync('assimp', ['export', `${name}.glb`, `${name}.obj`]);
    const lines = readFileSync(`${name}.obj`, 'utf8').split('\n').map((line) => line.split(/\s+/));
    const points = lines.filter(([word]) => word === 'v').map((line) => line.slice(1).map(Number));
    const faces = lines.filter(([word]) => word === 'f').length;
    const largest = [0, 1, 2].map((axis) => Math.max(...points.map((p) => Math.abs(p[axis]))));
    const own = getBounds(scene).max.map((x) => x.toFixed(3)).join(', ');
    const required = document.getRoot().listExtensionsRequired().map((extension) => extension.extensionName).join();
    console.log(`${name}: required "${required}", faults ${issues.numErrors + issues.numWarnings}, glTF-Transform's box up to ` +
        `${own}; assimp ${faces} faces, coordinates up to ${largest.join(', ')}`);
    return { faults: issues.numErrors + issues.numWarnings, own, required, faces, largest };
}

const floats = await look('floats');
await document.transform(quantize());
const short = await look('quantized');
const asStated = [floats, short].every(({ faults, own, faces }) => faults === 0 && own === '0.500, 1.000, 1.500' && faces === 12) &&
    `${floats.largest}` === '0.5,1,1.5' && short.required === 'KHR_mesh_quantization' &&
    short.largest[0] > 1e12 && short.largest[1] < 1e-37 && short.largest[2] === 0;
process.exit(asStated ? 0 : 1);
JAVASCRIPT
node quantize.js || { echo "changed: no longer as stated above" >&2; exit 1; }
