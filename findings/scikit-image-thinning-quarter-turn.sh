#!/usr/bin/env bash
# scikit-image 0.19.3 (Debian 12): whether thinning leaves a line or nothing at all depends on which way the bar lies.
#
# Expected: 3D skeletonization removes only voxels whose loss keeps the topology, so one solid bar leaves one component
#   whatever its size, and a quarter turn changes the skeleton by a voxel at most.
# Seen: a bar of 3 x 4 x 40 voxels with a margin around it leaves a line of 36 to 38 voxels in three of its six positions,
#   X
# Matters: a share of the limbs, struts and tubes of a collection have no skeleton, and which ones changes with the
#   resolution and with the pose of the model, so it looks like noise. Counting components before and after finds it at once;
#   a plot of one model does not.
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

cat > thin.py << 'PYTHON'
import sys
from itertools import permutations

import numpy as np
from skimage.measure import label
from skimage.morphology import skeletonize


def left(*shape):
    """Voxels that the skeleton of a solid box keeps; three layers of background lie around the box."""
    return int(np.count_nonzero(skeletonize(np.pad(np.ones(shape, bool), 3), method="lee")))


turned = {shape: left(*shape) for shape in sorted(set(permutations((3, 4, 40))))}
print("3 x 4 x 40 in its six positions:", turned)
square = {side: [left(*shape) for shape in set(permutations((side, side, 40)))] for side in (2, 3, 4, 5)}
print("square bars in their three positions:", square)
cubes = {side: left(side, side, side) for side in (2, 3, 4, 5, 8, 9, 16, 17)}
print("cubes:", cubes)
scene = np.zeros((60, 60, 60), bool)
scene[5:8, 5:9, 10:50] = True
scene[30:34, 30:33, 10:50] = True
skeleton = skeletonize(scene, method="lee") > 0
before, after = label(scene).max(), label(skeleton, connectivity=3).max()
print(f"two bars, a quarter turn apart: {before} components before, {after} after")

empty = sorted(shape for shape, count in turned.items() if count == 0)
as_stated = (
    empty == [(4, 3, 40), (4, 40, 3), (40, 3, 4)]
    and all(36 <= count <= 38 for shape, count in turned.items() if shape not in empty)
    and all(max(counts) == 0 if side % 2 == 0 else min(counts) > 0 for side, counts in square.items())
    and all((count == 0) == (side % 2 == 0) for side, count in cubes.items())
    and (before, after) == (2, 1)
)
sys.exit(0 if as_stated else 1)
PYTHON
python3 thin.py || { echo "changed: no longer as stated above" >&2; exit 1; }
