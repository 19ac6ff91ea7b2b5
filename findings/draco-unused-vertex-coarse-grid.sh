#!/usr/bin/env bash
# Debian draco 1.5.5: a vertex that no face uses is not written, and still sets the precision of all that are.
#
# Expected: draco_encoder rounds positions to 11 bits of the model's box. What no face uses is left out of the file, so the box
#   would be that of what is written: a unit cube comes back as a unit cube, whatever lies unused in the OBJ.
# Seen: the step is taken from the box of all vertices, before the unused ones go. A cube of edge 1 with one unused vertex at
#   x = 100 comes back with edge 0.977, at x = 10,000 as twelve triangles in one point, volume 0. Eight vertices are written
#   either way, so the file does not say why. Exit status 0, no message. -qp 0, without rounding, gives the cube.
# Matters: scanned and exported models often hold a stray point, which harms nobody until the model is compressed for the
#   web. Draw boxes from the corners of faces, and throw unused vertices away before encoding.
# Needs: apt-get, dpkg, python3. Exit 0: as stated. 1: changed. 2: not to be had.
set -euo pipefail
for tool in apt-get dpkg python3; do
    command -v "$tool" > /dev/null || { echo "$tool is missing" >&2; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

apt-get download draco=1.5.5+dfsg-2 libdraco7=1.5.5+dfsg-2 > /dev/null 2>&1 ||
    { echo "draco 1.5.5+dfsg-2 is not available (any more)" >&2; exit 2; }
for package in ./*.deb; do dpkg -x "$package" root; done
export LD_LIBRARY_PATH=$(echo "$work"/root/usr/lib/*-linux-gnu)

cat > cube.py << 'PYTHON'
import sys

corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
squares = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
stray = [(sys.argv[1], 0, 0)] if len(sys.argv) > 1 else []
for point in corners + stray:
    print("v", *point)
for a, b, c, d in squares:
    print("f", a + 1, b + 1, c + 1)
    print("f", a + 1, c + 1, d + 1)
PYTHON

cat > measure.py << 'PYTHON'
import sys

points, faces = [], []
for line in open(sys.argv[1]):
    words = line.split()
    if words and words[0] == "v":
        points.append([float(word) for word in words[1:4]])
    elif words and words[0] == "f":
        faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
volume = 0.0
for a, b, c in ((points[i] for i in face) for face in faces):
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
print(f"{len(points)} vertices {len(faces)} faces width {max(p[0] for p in points):.3f} volume {volume:.3f}")
PYTHON

through() { # STRAY [OPTION VALUE]
    local stray=$1
    shift
    python3 cube.py $stray > cube.obj
    root/usr/bin/draco_encoder -i cube.obj -o cube.drc "$@" > said.txt 2>&1 || { echo "the encoder failed"; return; }
    if grep -qiE "warn|unused|error" said.txt; then echo "a message"; return; fi
    root/usr/bin/draco_decoder -i cube.drc -o back.obj > /dev/null 2>&1
    python3 measure.py back.obj
}

{
    echo "no stray vertex: $(through "")"
    echo "at 100: $(through 100)"
    echo "at 10000: $(through 10000)"
    echo "at 10000, -qp 0: $(through 10000 -qp 0)"
} > seen.txt
cat seen.txt
expected='no stray vertex: 8 vertices 12 faces width 1.000 volume 1.000
at 100: 8 vertices 12 faces width 0.977 volume 0.933
at 10000: 8 vertices 12 faces width 0.000 volume 0.000
at 10000, -qp 0: 8 vertices 12 faces width 1.000 volume 1.000'
[[ $(cat seen.txt) == "$expected" ]] || { echo "changed: no longer as stated above" >&2; exit 1; }
