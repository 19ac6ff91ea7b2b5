#!/usr/bin/env bash
# assimp 5.2.5 (Debian 12): a glTF rig that bends its knee within a second leaves as glTF whole, as Collada unreadable or a
# thousand times too slow, as FBX without motion. Every export reports success.
#
# Expected: assimp converts between formats by way of one scene of its own, so what it reads rightly from glTF it writes
#   rightly to each rig format; at the least it reads its own files back.
# Seen, for a rig of two joints whose only motion is a turn of the knee at 0 s and 1 s:
#   glTF:    two keys, 1 s. Right.
#   Collada: with only the turn animated (as rigs are), the file names sources that it does not hold, and assimp refuses it.
#            With position, turn and scale animated alike it holds the times 0 and 1000; Collada counts seconds.
#   FBX:     the keys stand at 1000 s while the clip ends after 1 s, so assimp reads back one key: no motion.
#   (glTF is read in ticks of a thousandth of a second, and neither writer divides by the ticks.)
# Matters: a converter with exit code 0 is no proof of a conversion. Whoever turns uploads into one format by assimp loses the
#   motion of each glTF rig; meshes, joints and weights are all there, so counting them does not find it.
# Needs: apt-get with a package list of Debian 12, dpkg, python3. Exit 0: as stated. 1: changed. 2: not to be had.
set -euo pipefail
for tool in apt-get dpkg python3; do
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

cat > rig.py << 'PYTHON'
import base64, json, struct

blob, views, accessors = b"", [], []


def accessor(kind, code, component, values, **more):
    global blob
    data = struct.pack(f"<{len(values)}{code}", *values)
    size = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}[kind]
    views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
    accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind, "count": len(values) // size, **more})
    blob += data + b"\0" * (-len(data) % 4)
    return len(accessors) - 1


def floats(kind, values, **more):
    return accessor(kind, "f", 5126, values, **more)


strip = {
    "POSITION": floats("VEC3", [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], min=[0, 0, 0], max=[1, 1, 0]),
    "JOINTS_0": accessor("VEC4", "B", 5121, [0, 0, 0, 0] * 2 + [1, 0, 0, 0] * 2),
    "WEIGHTS_0": floats("VEC4", [1, 0, 0, 0] * 4),
}
corners = accessor("SCALAR", "H", 5123, [0, 1, 2, 0, 2, 3])
unit = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
inverse = floats("MAT4", unit + unit[:13] + [-1] + unit[14:])
times = floats("SCALAR", [0, 1], min=[0], max=[1])
tracks = {
    "rotation": floats("VEC4", [0, 0, 0, 1, 0, 0, 0.5**0.5, 0.5**0.5]),
    "translation": floats("VEC3", [0, 1, 0] * 2),
    "scale": floats("VEC3", [1, 1, 1] * 2),
}
for name, paths in (("turn", ["rotation"]), ("all", ["rotation", "translation", "scale"])):
    motion = {
        "name": "bend",
        "samplers": [{"input": times, "output": tracks[path]} for path in paths],
        "channels": [{"sampler": k, "target": {"node": 1, "path": path}} for k, path in enumerate(paths)],
    }
    rig = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
        "nodes": [{"name": "hip", "children": [1]}, {"name": "knee", "translation": [0, 1, 0]}, {"name": "leg", "mesh": 0, "skin": 0}],
        "meshes": [{"primitives": [{"attributes": strip, "indices": corners}]}],
        "skins": [{"joints": [0, 1], "inverseBindMatrices": inverse}], "animations": [motion],
        "buffers": [{"byteLength": len(blob), "uri": "data:application/octet-stream;base64," + base64.b64encode(blob).decode()}],
        "bufferViews": views, "accessors": accessors,
    }
    json.dump(rig, open(f"{name}.gltf", "w"))
PYTHON
python3 rig.py

# Writes $1 as format $2 into $3, reads that back; prints the clip's seconds and the keys of the knee's turn, or that it is refused.
round_trip() {
    assimp export "$1" "$3" "-f$2" > log || { echo "export failed"; return; }
    assimp export "$3" back.assxml > log || { grep -q '^ERROR: Failed to load' log && echo "refused"; return; }
    python3 -c '
import re
text = open("back.assxml").read()
clip = re.search(r"<Animation name=\"[^\"]*\" duration=\"([^\"]*)\" tick_cnt=\"([^\"]*)\"", text)
keys = re.search(r"<NodeAnim node=\"knee\">.*?<RotationKeyList num=\"(\d+)\"", text, re.S)
print(f"{float(clip[1]) / float(clip[2]):g} s, {keys[1]} keys")'
}
seen=$(for name in turn all; do
    echo "$name, glTF: $(round_trip $name.gltf gltf2 $name.out.gltf)"
    echo "$name, Collada: $(round_trip $name.gltf collada $name.dae)"
    echo "$name, FBX: $(round_trip $name.gltf fbxa $name.fbx)"
done)
echo "$seen"
times=$(sed -n 's/.*knee_matrix-input-array" count="2"> *\(.*[^ ]\) *<.*/\1/p' all.dae)
ticks=$(grep -o '0,46186158[0-9]*' all.fbx | sort -u) # an FBX second has 46186158000 ticks
echo "times in the Collada file: $times; in the FBX file: $ticks"
expected='turn, glTF: 1 s, 2 keys
turn, Collada: refused
turn, FBX: 1 s, 1 keys
all, glTF: 1 s, 2 keys
all, Collada: 1000 s, 2 keys
all, FBX: 1 s, 1 keys'
[[ $seen == "$expected" && $times == "0 1000" && $ticks == 0,46186158000000 ]] ||
    { echo "changed: no longer as stated above" >&2; exit 1; }
