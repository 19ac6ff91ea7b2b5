#!/usr/bin/env bash
# faiss 1.7.3 (Debian 12): an "exact" flat index answers 19 queries rightly and the same queries wrongly when a 20th joins.
#
# Expected: IndexFlatL2 compares every vector with every query, so it is the yardstick that approximate indexes are judged
#   by. How many queries share one call is a matter of speed; the neighbours of a query do not depend on its company.
# Seen: up to 19 queries a call are compared by differences. From 20 on the distances come from a matrix product as
#   |x|^2 + |q|^2 - 2 x.q in single precision, and what is common to all vectors cancels away. A scan of 3,000 points in a
#   cube of 100 mm that stands 50 m from the origin, asked by the same scan with 0.2 mm of noise: right neighbour for all of
#   400 queries in calls of 19, for about 4 % of them in one call of 400, where every distance is exactly 0. Moved to the
#   origin, both ways agree. The limit of 20 is faiss.cvar.distance_compute_blas_threshold.
# Matters: registration of scans and search by uncentred descriptors give one answer in a unit test with a few queries and
#   another in the batch job, with no warning and with a recall that was "measured against the exact index". Subtract the
#   mean first, or raise the threshold.
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
debian python3-faiss=1.7.3-2+b1 python3-numpy=1:1.24.2-1+deb12u1 libblas3=3.11.0-2 liblapack3=3.11.0-2 \
    libgfortran5=12.2.0-14+deb12u1 libquadmath0=12.2.0-14+deb12u1 libgomp1=12.2.0-14+deb12u1
libraries=$(echo "$work"/root/usr/lib/*-linux-gnu)
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
export LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack

cat > ask.py << 'PYTHON'
import sys

import faiss
import numpy as np

QUERIES, FEW = 400, faiss.cvar.distance_compute_blas_threshold - 1


def shares(offset):
    """Share of right neighbours in calls of FEW queries and in one call, and the largest distance of the one call."""
    random = np.random.default_rng(3)
    points = (random.uniform(0, 100, (3000, 3)) + offset).astype(np.float32)
    queries = (points + random.normal(0, 0.2, points.shape))[:QUERIES].astype(np.float32)
    index = faiss.IndexFlatL2(3)
    index.add(points)
    exact = [np.argmin(((points.astype(float) - query) ** 2).sum(axis=1)) for query in queries.astype(float)]
    few = np.concatenate([index.search(queries[k:k + FEW], 1)[1][:, 0] for k in range(0, QUERIES, FEW)])
    distances, together = index.search(queries, 1)
    return np.mean(few == exact), np.mean(together[:, 0] == exact), distances.max()


near, far = shares(0), shares(50000)
print(f"at most {FEW} queries a call: right {near[0]:.3f} at the origin, {far[0]:.3f} at 50 m")
print(f"{QUERIES} queries in one call:  right {near[1]:.3f} at the origin, {far[1]:.3f} at 50 m, largest distance {far[2]}")
as_stated = FEW == 19 and near[0] == near[1] == far[0] == 1 and far[1] < 0.25
sys.exit(0 if as_stated else 1)
PYTHON
python3 ask.py || { echo "changed: no longer as stated above" >&2; exit 1; }
