#!/usr/bin/env bash
# three.js 0.187.0 and assimp 5.2.5 (Debian 12): one BVH file of captured motion, bones of length 1 in one and 2 in the other.
#
# Expected: BVH is a small, old text format, so two readers of long standing agree on where the joints of a frame are, also
#   where every joint has six channels, three of them positions.
# Seen: assimp takes a position channel in place of the joint's OFFSET, three.js adds it to the OFFSET. Where the channels
#   hold the whole way from the parent, three.js puts the hip at height 20 for 10 and makes the shin 2 long for 1. Where they
#   hold only what is added (0), assimp's shin has no length. Rotations agree to the sixth digit, so both look plausible.
# Matters: all bones twice as long is a person of twice the size and looks right in a viewer that fits the camera; lengths
#   of bones, a rig matched by proportions, and feet on the ground are wrong. Compare |position| with |OFFSET| in frame 0.
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
export LD_LIBRARY_PATH
export npm_config_cache=$work/cache npm_config_update_notifier=false
echo '{"private": true, "type": "module"}' > package.json
npm install --silent --no-audit --no-fund three@0.187.0 > /dev/null 2>&1 ||
    { echo "three 0.187.0 is not available (any more)" >&2; exit 2; }

# The hip stands at height 10, the shin is 1 long. $2: what the position channels of the shin hold.
capture() {
    cat > "$1" << BVH
HIERARCHY
ROOT Hip
{
  OFFSET 0 10 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Shin
  {
    OFFSET 0 -1 0
    CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 -1 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.04
0 10 0 0 0 0 $2 0 0 0
0 10 0 30 40 50 $2 10 60 20
BVH
}
capture repeated.bvh "0 -1 0"
capture zero.bvh "0 0 0"
for name in repeated zero; do
    "$work/root/usr/bin/assimp" export $name.bvh $name.assxml > /dev/null || { echo "changed: assimp refuses $name.bvh" >&2; exit 1; }
done

cat > compare.js << 'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import { BVHLoader } from 'three/addons/loaders/BVHLoader.js';

function byThree(name) {
    const { tracks } = new BVHLoader().parse(readFileSync(`${name}.bvh`, 'utf8')).clip;
    const of = (track, first, count) => [...tracks.find((t) => t.name === track).values].slice(first, first + count);
    return { hip: of('Hip.position', 0, 3), shin: of('Shin.position', 0, 3), turn: of('Shin.quaternion', 4, 4) };
}

function byAssimp(name) {
    const text = readFileSync(`${name}.assxml`, 'utf8');
    const keys = (node, kind) => [...text.split(`<NodeAnim node="${node}">`)[1].split('</NodeAnim>')[0]
        .matchAll(new RegExp(`<${kind} [^>]*>([^<]*)<`, 'g'))].map((m) => m[1].trim().split(/\s+/).map(Number));
    return { hip: keys('Hip', 'PositionKey')[0], shin: keys('Shin', 'PositionKey')[0], turn: keys('Shin', 'RotationKey')[1] };
}

let asStated = true;
const expected = { repeated: '20 -2 10 -1', zero: '20 -1 10 0' };
for (const name of ['repeated', 'zero']) {
    const three = byThree(name), assimp = byAssimp(name);
    const heights = [three.hip[1], three.shin[1], assimp.hip[1], assimp.shin[1]];
    const turned = Math.max(...three.turn.map((x, i) => Math.abs(x - assimp.turn[i])));
    console.log(`${name}: three.js hip ${heights[0]}, shin ${heights[1]}; assimp hip ${heights[2]}, shin ${heights[3]}; ` +
        `rotations differ by ${turned.toExponential(0)}`);
    asStated &&= heights.join(' ') === expected[name] && turned < 1e-4;
}
process.exit(asStated ? 0 : 1);
JAVASCRIPT
node compare.js || { echo "changed: no longer as stated above" >&2; exit 1; }
