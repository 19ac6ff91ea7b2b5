#!/usr/bin/env bash
# OpenMesh 9.0 (Debian 12): a cap of 300 corners goes into a binary PLY as 44, and OpenMesh reads its own file "successfully".
#
# Expected: write_mesh and read_mesh answer true, so a polygon mesh comes back as it went, in binary as in text.
# Seen: a cylinder with two caps of 300 corners (302 faces, volume 3.14). Text PLY and OBJ come back whole. In binary PLY the
#   count of a face is one byte: 300 is written as 44, followed by all 300 indices, so all that follows is read out of step.
#   write_mesh: true, nothing on stderr. read_mesh of that file: true, 291 faces, volume 2.04, and a line on stderr about
#   invalid faces. assimp 5.2.5 does the same in its binary PLY, reports success, and then refuses its own file.
# Matters: caps of turned parts, and flat faces of CAD models, easily have more than 255 corners. The damage is done when the
#   file is written; a reader can only notice that the counts do not fill the file. Triangulate before writing PLY.
# Needs: apt-get with a package list of Debian 12, dpkg, g++, python3. Exit 0: as stated. 1: changed. 2: not to be had.
set -euo pipefail
for tool in apt-get dpkg python3 g++; do
    command -v "$tool" > /dev/null || { echo "$tool is missing" >&2; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

debian() {
    apt-get -qq download "$@" > /dev/null 2>&1 || { echo "not all available (any more): $*" >&2; exit 2; }
    for archive in *.deb; do dpkg -x "$archive" root; done
}
debian libopenmesh-dev=9.0-4+b1 assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 \
    libminizip1=1.1-8+deb12u1
libraries=$(echo "$work"/root/usr/lib/*-linux-gnu)
export LD_LIBRARY_PATH=$libraries PATH=$work/root/usr/bin:$PATH

cat > trip.cpp << 'CPP'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

Mesh cylinder(int corners) {
    Mesh mesh;
    std::vector<Mesh::VertexHandle> low, high;
    for (int i = 0; i < 2 * corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        (i < corners ? low : high).push_back(mesh.add_vertex({float(cos(angle)), float(sin(angle)), i < corners ? 0.f : 1.f}));
    }
    mesh.add_face(std::vector<Mesh::VertexHandle>(low.rbegin(), low.rend()));
    mesh.add_face(high);
    for (int i = 0, next = 1; i < corners; ++i, next = (i + 1) % corners)
        mesh.add_face(low[i], low[next], high[next], high[i]);
    return mesh;
}

void tell(const std::string& name, bool success, const Mesh& mesh) {
    double volume = 0;
    for (const auto face : mesh.faces()) {
        std::vector<Mesh::Point> p;
        for (const auto vertex : mesh.fv_range(face)) p.push_back(mesh.point(vertex));
        for (size_t i = 2; i < p.size(); ++i) volume += (p[0] | (p[i - 1] % p[i])) / 6;
    }
    std::cout << name << ": " << success << ", " << mesh.n_faces() << " faces, volume " << std::setprecision(3) << volume << "\n";
}

int main() {
    using OpenMesh::IO::Options;
    for (const std::string name : {"200.bin.ply", "300.txt.ply", "300.bin.ply", "300.obj"}) {
        const bool binary = name.find("bin") != std::string::npos;
        const bool written = write_mesh(cylinder(std::stoi(name)), name, binary ? Options(Options::Binary) : Options());
        Mesh back;
        const bool success = OpenMesh::IO::read_mesh(back, name);
        tell(name, written && success, back);
    }
}
CPP
g++ -std=c++17 -O1 -I root/usr/include trip.cpp -L "$libraries" -lOpenMeshCore -o trip
seen=$(./trip 2> /dev/null)
echo "$seen"

# The caps come first: one byte of count each, and what lies between the first count and the sides.
python3 - << 'PYTHON'
data = open("300.bin.ply", "rb").read()
cap = data.index(b"end_header\n") + 11 + 600 * 12
side = len(data) - 300 * (1 + 4 * 4)
print(f"count of the first cap in the file: {data[cap]}, of the first side: {data[side]}; bytes for the caps: {side - cap}")
raise SystemExit(0 if (data[cap], data[side], side - cap) == (44, 4, 2 * (1 + 300 * 4)) else 1)
PYTHON
assimp export 300.obj by-assimp.ply -fplyb > /dev/null
by_assimp=$(assimp info by-assimp.ply 2>&1 | grep -c '^ERROR: Failed to load file' || true)
echo "assimp writes the cylinder as binary PLY; refused when read back: $by_assimp"
expected='200.bin.ply: 1, 202 faces, volume 3.14
300.txt.ply: 1, 302 faces, volume 3.14
300.bin.ply: 1, 291 faces, volume 2.04
300.obj: 1, 302 faces, volume 3.14'
[[ $seen == "$expected" && $by_assimp == 1 ]] || { echo "changed: no longer as stated above" >&2; exit 1; }
