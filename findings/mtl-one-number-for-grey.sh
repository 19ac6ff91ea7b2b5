#!/usr/bin/env bash
# three.js 0.187.0, obj2gltf 3.2.0, assimp 5.2.5 (Debian 12): the short form of a grey in an MTL file, `Kd 0.5`, is three other
# colours, and one of them makes an invalid glTF file.
#
# Expected: the format's description lets green and blue be left out, which then equal red: one number is a grey. Readers
#   that take `Kd 0.5 0.5 0.5` take `Kd 0.5`; at the least they say that something is missing.
# Seen: assimp reads (0.5, 0, 0), a dark red. three.js' MTLLoader makes a colour of (0.214, NaN, NaN), whose hex string is
#   "000NaN". obj2gltf writes "baseColorFactor": [0.5, null, null, 1], which the glTF schema forbids (numbers). The material
#   with three numbers beside it is right in all three. No message, exit status 0.
# Matters: a model's colour depends on the reader, and a converted file fails only in the program that is next. Whoever
#   writes MTL should write all three numbers; whoever reads it has to fill in the two.
# Needs: apt-get with a package list of Debian 12, dpkg, node 18 or later, npm, python3. Exit 0: as stated. 1: changed. 2: not to be had.
set -euo pipefail
for tool in apt-get dpkg node npm python3; do
    command -v "$tool" > /dev/null || { echo "$tool is missing" >&2; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

export npm_config_cache=$work/cache npm_config_update_notifier=false
echo '{"private": true}' > package.json
npm install --silent --no-audit --no-fund three@0.187.0 obj2gltf@3.2.0 > /dev/null 2>&1 ||
    { echo "three 0.187.0 or obj2gltf 3.2.0 is not available (any more)" >&2; exit 2; }
packages=(assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1)
apt-get -qq download "${packages[@]}" > /dev/null 2>&1 || { echo "not all available (any more): ${packages[*]}" >&2; exit 2; }
for archive in *.deb; do dpkg -x "$archive" root; done
LD_LIBRARY_PATH=$(echo "$work"/root/usr/lib/*-linux-gnu)
export LD_LIBRARY_PATH

printf 'newmtl short\nKd 0.5\nnewmtl long\nKd 1 0.8 0\n' > square.mtl
cat > square.obj << 'OBJ'
mtllib square.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
usemtl short
f 1 2 3
usemtl long
f 1 3 4
OBJ
"$work/root/usr/bin/assimp" export square.obj assimp.gltf > /dev/null
node node_modules/obj2gltf/bin/obj2gltf.js -i square.obj -o obj2gltf.gltf > /dev/null

cat > read.mjs << 'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';

const library = new MTLLoader().parse(readFileSync('square.mtl', 'utf8'), '');
library.preload();
for (const name of ['short', 'long']) {
    const { color } = library.materials[name];
    console.log(`three.js ${name}: ${color.toArray().map((x) => x.toFixed(3)).join(' ')} #${color.getHexString()}`);
}
JAVASCRIPT
{
    node read.mjs
    python3 - << 'PYTHON'
import json

for program in ("assimp", "obj2gltf"):
    with open(f"{program}.gltf") as file:
        for material in json.load(file)["materials"]:
            factor = material["pbrMetallicRoughness"]["baseColorFactor"]
            if material["name"] in ("short", "long"):
                print(f"{program} {material['name']}:", *("null" if x is None else f"{x:.3f}" for x in factor[:3]))
PYTHON
} | tee seen
cat > stated << 'TEXT'
three.js short: 0.214 NaN NaN #000NaN
three.js long: 1.000 0.604 0.000 #ffcc00
assimp short: 0.500 0.000 0.000
assimp long: 1.000 0.800 0.000
obj2gltf short: 0.500 null null
obj2gltf long: 1.000 0.800 0.000
TEXT
diff stated seen || { echo "changed: no longer as stated above" >&2; exit 1; }
