#!/usr/bin/env bash
# three.js 0.187.0 and assimp 5.2.5 (Debian 12): a reader drops the caps of a cylinder, depending on the format and the corners.
#
# Expected: OFF, PLY and OBJ store polygons of any number of corners; a reader that wants triangles cuts them up, or says that
#   it does not. So a prism of n sides has 4 n - 4 triangles, whichever text file it comes from.
# Seen: three.js' PLYLoader takes polygons of three and four corners and drops all others, while its OBJLoader cuts up every
#   one. A prism of 5 sides has 10 triangles for 16: it is a tube. A model of such faces alone is points without a mesh.
#   assimp's OFF reader keeps 9 corners and drops 10: a prism of 12 sides has 24 triangles for 44, while assimp's readers of
#   PLY and OBJ have all 44. Both report success; neither throws; three.js prints nothing.
# Matters: scanners write triangles, so the readers look right on every scan; modellers and CAD write caps. An open tube
#   has no volume, is voxelized hollow and matches other shapes. Count the corners in the file, not only the faces that come.
# Needs: apt-get with a package list of Debian 12, dpkg, node 20 or later, npm. Exit 0: as stated. 1: changed. 2: not to be had.
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
npm install --silent --no-audit --no-fund three@0.187.0 > /dev/null 2>&1 ||
    { echo "three 0.187.0 is not available (any more)" >&2; exit 2; }

cat > prisms.js << 'JAVASCRIPT'
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';

function prism(sides) {
    const ring = [...Array(sides).keys()];
    const points = [0, 1].flatMap((z) => ring.map((i) => [Math.cos(2 * Math.PI * i / sides), Math.sin(2 * Math.PI * i / sides), z]));
    const walls = ring.map((i) => [i, (i + 1) % sides, sides + (i + 1) % sides, sides + i]);
    return [points, [ring.toReversed(), ring.map((i) => sides + i), ...walls]];
}

const lines = (rows) => rows.map((row) => row.join(' ')).join('\n') + '\n';
const counted = (faces) => faces.map((face) => [face.length, ...face]);
const write = {
    off: (points, faces) => `OFF\n${points.length} ${faces.length} 0\n` + lines(points) + lines(counted(faces)),
    obj: (points, faces) => lines(points.map((p) => ['v', ...p])) + lines(faces.map((face) => ['f', ...face.map((i) => i + 1)])),
    ply: (points, faces) => `ply\nformat ascii 1.0\nelement vertex ${points.length}\nproperty float x\nproperty float y\n` +
        `property float z\nelement face ${faces.length}\nproperty list uchar int vertex_indices\nend_header\n` +
        lines(points) + lines(counted(faces)),
};

function byAssimp(format, text) {
    writeFileSync(`model.${format}`, text);
    return Number(execFileSync('assimp', ['info', `model.${format}`], { encoding: 'utf8' }).match(/^Faces: +(\d+)/m)[1]);
}
const byThreePly = (text) => (new PLYLoader().parse(text).index?.count ?? 0) / 3;
const byThreeObj = (text) => new OBJLoader().parse(text).children[0].geometry.attributes.position.count / 3;

let asStated = true;
for (const sides of [4, 5, 9, 10, 12]) {
    const text = Object.fromEntries(Object.keys(write).map((format) => [format, write[format](...prism(sides))]));
    const whole = 4 * sides - 4, tube = 2 * sides;
    const three = [byThreePly(text.ply), byThreeObj(text.obj)];
    const assimp = ['ply', 'obj', 'off'].map((format) => byAssimp(format, text[format]));
    console.log(`${sides} sides, ${whole} triangles: three.js PLY, OBJ ${three}; assimp PLY, OBJ, OFF ${assimp}`);
    asStated &&= `${three}` === `${[sides > 4 ? tube : whole, whole]}` && `${assimp}` === `${[whole, whole, sides > 9 ? tube : whole]}`;
}

const pentagon = byThreePly(write.ply(prism(5)[0], prism(5)[1].slice(0, 2)));
console.log(`the two caps of 5 corners alone: three.js PLY ${pentagon}`);
process.exit(asStated && pentagon === 0 ? 0 : 1);
JAVASCRIPT
node prisms.js || { echo "changed: no longer as stated above" >&2; exit 1; }
