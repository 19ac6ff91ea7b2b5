#!/usr/bin/env bash
# three.js 0.187.0: one posed, skinned figure leaves as STL bent and as OBJ and PLY straight.
#
# Expected: the three exporters of one library write the same scene. All three put the matrix of the node into the vertices, so
#   they write what is seen; one would guess that all follow the bones, or that none does.
# Seen: an arm of 1 x 4 x 1, its upper half turned by a right angle. STLExporter asks the bones: box 2.5 x 2.5 x 1,
#   volume 3.5 (linear blending shrinks the elbow). OBJExporter and PLYExporter write the vertices of the rest pose: box
#   1 x 4 x 1, volume 4. No message. Box3.setFromObject, asked for precision, sides with the STL.
# Matters: the same model, sent to a slicer and to a search by shape, has two shapes; a copy test between the formats
#   says "different", and a measure of pose finds none in OBJ and PLY. Bake the pose into the vertices before exporting.
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
npm install --silent --no-audit --no-fund three@0.187.0 > /dev/null 2>&1 ||
    { echo "three 0.187.0 is not available (any more)" >&2; exit 2; }

cat > pose.js << 'JAVASCRIPT'
import * as THREE from 'three';
import { OBJExporter } from 'three/addons/exporters/OBJExporter.js';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

globalThis.requestAnimationFrame = (call) => call(); // PLYExporter hands its result over in the next frame

// The arm stands on both sides of its elbow at the origin; what lies above belongs to the second bone.
const shape = new THREE.BoxGeometry(1, 4, 1, 1, 4, 1);
const heights = Array.from({ length: shape.attributes.position.count }, (_, i) => shape.attributes.position.getY(i));
shape.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(heights.flatMap((y) => [y > 0 ? 1 : 0, 0, 0, 0]), 4));
shape.setAttribute('skinWeight', new THREE.Float32BufferAttribute(heights.flatMap(() => [1, 0, 0, 0]), 4));
const arm = new THREE.SkinnedMesh(shape, new THREE.MeshBasicMaterial());
const [lower, upper] = [new THREE.Bone(), new THREE.Bone()];
arm.add(lower.add(upper));
arm.bind(new THREE.Skeleton([lower, upper]));
upper.rotation.z = Math.PI / 2;
const scene = new THREE.Scene().add(arm);
scene.updateMatrixWorld(true);

function measured(geometry) {
    const points = (geometry.index ? geometry.toNonIndexed() : geometry).attributes.position;
    const corner = (i) => new THREE.Vector3().fromBufferAttribute(points, i);
    let volume = 0;
    for (let i = 0; i < points.count; i += 3) volume += corner(i).dot(corner(i + 1).cross(corner(i + 2))) / 6;
    return [...new THREE.Box3().setFromBufferAttribute(points).getSize(new THREE.Vector3()), volume].map((x) => x.toFixed(3)).join(' ');
}

const seen = {
    STL: measured(new STLLoader().parse(new STLExporter().parse(scene, { binary: true }).buffer)),
    OBJ: measured(new OBJLoader().parse(new OBJExporter().parse(scene)).children[0].geometry),
};
new PLYExporter().parse(scene, (file) => { seen.PLY = measured(new PLYLoader().parse(file)); }, { binary: true });
const box = new THREE.Box3().setFromObject(scene, true).getSize(new THREE.Vector3()).toArray().map((x) => x.toFixed(3)).join(' ');
for (const [format, values] of Object.entries(seen)) console.log(`${format}: box and volume ${values}`);
console.log(`Box3.setFromObject, precise: ${box}`);
const bent = '2.500 2.500 1.000', straight = '1.000 4.000 1.000 4.000';
process.exit(seen.STL === `${bent} 3.500` && seen.OBJ === straight && seen.PLY === straight && box === bent ? 0 : 1);
JAVASCRIPT
node pose.js || { echo "changed: no longer as stated above" >&2; exit 1; }
