#!/usr/bin/env bash
# GCC 12.2 (Debian 12): rounding positions to floats, x = double(float(x)), is left out at -O3 for some of the coordinates.
#
# Expected: converting a double to float and back rounds it; whoever stores positions as floats (STL, glTF, PLY) and wants to
#   compare with them afterwards rounds them first by that loop. Optimisation may change its speed.
# Seen: for a std::vector<std::array<double, 3>> with one to nine points, one to five coordinates keep digits that no float has,
#   in seven of nine lengths. Which ones depends on the length: the part of the loop that is vectorised drops both conversions,
#   as if -ffast-math had been asked for. Right at -O1, at -O2, and at -O3 with -fno-tree-vectorize; a volatile float between
#   the two conversions helps as well.
# Matters: "the same positions" from a file of floats and from memory then differ in the eighth digit, and only in some of the
#   points, only in the optimised build. Whatever hashes or welds vertices exactly sees other vertices.
# Needs: apt-get with a package list of Debian 12, dpkg, and what a C++ compiler needs besides itself (as, ld, headers of libc).
#   Exit 0: as stated. 1: changed. 2: not to be had.
set -euo pipefail
for tool in apt-get dpkg as ld; do
    command -v "$tool" > /dev/null || { echo "$tool is missing" >&2; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
version=12.2.0-14+deb12u1
packages=()
for name in g++-12 gcc-12 cpp-12 libgcc-12-dev libstdc++-12-dev; do packages+=("$name=$version"); done
apt-get -qq download "${packages[@]}" > /dev/null 2>&1 ||
    { echo "not all available (any more): ${packages[*]}" >&2; exit 2; }
for archive in *.deb; do dpkg -x "$archive" root; done
compiler=$(echo "$work"/root/usr/bin/*-linux-gnu-g++-12)
[[ -x $compiler ]] || compiler=$work/root/usr/bin/g++-12
"$compiler" --version | head -1

cat > round.cpp << 'CPP'
#include <array>
#include <cstdio>
#include <vector>

using Point = std::array<double, 3>;

void round_to_floats(std::vector<Point>& points) {
    for (Point& point : points) {
        for (double& x : point) x = static_cast<double>(static_cast<float>(x));
    }
}

int main(int count, char**) {
    for (int n = 1; n <= 9; ++n) {
        std::vector<Point> points(static_cast<std::size_t>(n));
        for (int i = 0; i < 3 * n; ++i) points[i / 3][i % 3] = 0.1 * (i + count);
        round_to_floats(points);
        int kept = 0;
        for (int i = 0; i < 3 * n; ++i) {
            const volatile float rounded = static_cast<float>(0.1 * (i + count));
            kept += points[i / 3][i % 3] != static_cast<double>(rounded);
        }
        std::printf(n == 1 ? "%d" : " %d", kept);
    }
    std::printf("\n");
}
CPP
seen() { # FLAGS...: of 1 to 9 points, how many coordinates were not rounded
    "$compiler" -B "$work/root/usr/lib/gcc/x86_64-linux-gnu/12/" -std=c++20 "$@" round.cpp -o round
    echo "$*: $(./round)"
}
observed=$(seen -O2; seen -O3; seen -O3 -fno-tree-vectorize)
echo "coordinates that were not rounded, of 1 to 9 points"
echo "$observed"
expected='-O2: 0 0 0 0 0 0 0 0 0
-O3: 2 3 5 0 2 4 5 0 1
-O3 -fno-tree-vectorize: 0 0 0 0 0 0 0 0 0'
[[ $observed == "$expected" ]] || { echo "changed: no longer as stated above" >&2; exit 1; }
