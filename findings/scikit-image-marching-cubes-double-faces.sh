#!/usr/bin/env bash
# scikit-image 0.19.3 (Debian 12): on voxels, the "topologically correct" marching cubes write faces twice; the old one does not.
#
# Expected: marching_cubes has two methods. The default, lewiner, is the one that settles the ambiguous cases and is promised
#   to be right topologically; lorensen is the classic one, which settles nothing. So the default is the safe choice for a
#   solid of voxels, and each edge of its mesh belongs to two triangles.
# Seen: four voxels that touch only along edges, level 0.5. lorensen: 32 triangles, every edge in two of them, four separate
#   octahedra of 1/6 each. lewiner: 52 triangles, two of them there twice with the same corners in the same sense, three
#   edges in four triangles, twice the volume. Of 100 blocks of 5 x 5 x 5 voxels drawn at random (40 % full) 24 have such
#   edges by lewiner, none by lorensen. On random real values neither method has one: voxels are all 0 or 1, so what should
#   settle an ambiguous face compares two equal products each time.
# Matters: a half-edge structure takes at most two faces an edge. The OFF reader of OpenMesh 9.0, for one, says "complex edge"
#   and gives four of these faces vertices of their own (24 become 36): the closed surface has cuts, and lengths along it
#   and counts of components are wrong. Smooth the volume a little, or ask for lorensen.
# Needs: apt-get with a package list of Debian 12, dpkg, python3 (3.11). Exit 0: as stated. 1: changed. 2: not to be had.
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
debian python3-skimage=0.19.3-8 python3-skimage-lib=0.19.3-8+b1 python3-scipy=1.10.1-2 python3-numpy=1:1.24.2-1+deb12u1 \
    python3-decorator=5.1.1-3 python3-packaging=23.0-1 libblas3=3.11.0-2 liblapack3=3.11.0-2 liblbfgsb0=3.0+dfsg.4-1 \
    libgfortran5=12.2.0-14+deb12u1 libquadmath0=12.2.0-14+deb12u1
libraries=$(echo "$work"/root/usr/lib/*-linux-gnu)
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
export LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack

cat > cubes.py << 'PYTHON'
import sys
from collections import Counter

import numpy as np
from skimage.measure import marching_cubes


def mesh(volume, method):
    """Triangles, how many of them repeat another, edges in more than two triangles, and the volume inside."""
    points, faces, _, _ = marching_cubes(volume, 0.5, method=method)
    edges = Counter(tuple(sorted((a, b))) for f in faces.tolist() for a, b in zip(f, f[1:] + f[:1]))
    a, b, c = points[faces].astype(float).transpose(1, 0, 2)
    inside = abs((a * np.cross(b, c)).sum()) / 6
    repeated = len(faces) - len({tuple(sorted(f)) for f in faces.tolist()})
    return len(faces), repeated, sum(n > 2 for n in edges.values()), round(inside, 4)


four = np.zeros((5, 5, 4))
for voxel in [(1, 2, 1), (1, 3, 2), (2, 1, 1), (2, 2, 2)]:
    four[voxel] = 1
random = np.random.default_rng(1)
blocks = [np.pad((random.random((5, 5, 5)) < 0.4).astype(float), 1) for _ in range(100)]
real = [np.pad(random.random((5, 5, 5)), 1) for _ in range(100)]
seen = {}
for method in ("lewiner", "lorensen"):
    binary = sum(mesh(block, method)[2] > 0 for block in blocks)
    smooth = sum(mesh(block, method)[2] > 0 for block in real)
    seen[method] = (mesh(four, method), binary, smooth)
    print(f"{method}: triangles, repeated, edges in more than two, volume {seen[method][0]};",
          f"of 100 blocks with such edges: {binary} of voxels, {smooth} of real values")
(new, new_blocks, new_real), (old, old_blocks, old_real) = seen["lewiner"], seen["lorensen"]
as_stated = new == (52, 2, 3, 1.3333) and old == (32, 0, 0, 0.6667) and new_blocks >= 20 and old_blocks == new_real == old_real == 0
sys.exit(0 if as_stated else 1)
PYTHON
python3 cubes.py || { echo "changed: no longer as stated above" >&2; exit 1; }
