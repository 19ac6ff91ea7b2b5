#include "engine/skeleton/junction_clusters.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "engine/skeleton/simple_point.h"

namespace ossuary::skeleton {
namespace {

using Corner = std::tuple<int, int, int>;
/// Corners and the lattice edges between them (by the lower corner and the axis) of a set.
struct Cells {
    std::set<Corner> corners;
    std::set<std::pair<Corner, int>> edges;
};

Cells cells_of(const std::vector<VoxelIndex>& voxels, const PaddedShape& shape) {
    Cells cells;
    for (const VoxelIndex voxel : voxels) {
        const Vec3i p = shape.position(voxel);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3i c = p + Vec3i(corner & 1, corner >> 1 & 1, corner >> 2);
            cells.corners.insert({c.x(), c.y(), c.z()});
            for (int axis = 0; axis < 3; ++axis) {
                if ((corner >> axis & 1) == 0) cells.edges.insert({{c.x(), c.y(), c.z()}, axis});
            }
        }
    }
    return cells;
}

Neighborhood members_around(VoxelIndex voxel, const std::vector<VoxelIndex>& members,
                            const std::array<std::int32_t, 27>& steps) {
    Neighborhood around = 0;
    for (int bit = 0; bit < 27; ++bit) {
        const VoxelIndex n = moved(voxel, steps[static_cast<std::size_t>(bit)]);
        if (bit != kCentreBit && std::find(members.begin(), members.end(), n) != members.end()) {
            around |= Neighborhood{1} << bit;
        }
    }
    return around;
}

}  // namespace

std::vector<std::vector<VoxelIndex>> contractible_pieces(const std::vector<VoxelIndex>& voxels,
                                                         const PaddedShape& shape) {
    const auto steps = shape.neighbor_steps();
    const SimplePointTest& is_simple = SimplePointTest::shared();
    std::vector<VoxelIndex> rest = voxels;
    std::vector<std::vector<VoxelIndex>> pieces;
    while (!rest.empty()) {
        std::vector<VoxelIndex> piece = {rest.front()};
        rest.erase(rest.begin());
        // A piece grows by simple points, each of which deforms it only.
        for (bool grown = true; grown;) {
            grown = false;
            for (auto it = rest.begin(); it != rest.end();) {
                if (is_simple(members_around(*it, piece, steps))) {
                    piece.push_back(*it);
                    it = rest.erase(it);
                    grown = true;
                } else {
                    ++it;
                }
            }
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

int contacts(const std::vector<VoxelIndex>& a, const std::vector<VoxelIndex>& b,
             const PaddedShape& shape) {
    const Cells cells_a = cells_of(a, shape);
    const Cells cells_b = cells_of(b, shape);
    std::map<Corner, Corner> parent;
    for (const Corner& corner : cells_a.corners) {
        if (cells_b.corners.contains(corner)) parent[corner] = corner;
    }
    const auto root = [&](Corner corner) {
        while (parent.at(corner) != corner) corner = parent.at(corner);
        return corner;
    };
    auto count = static_cast<int>(parent.size());
    for (const auto& [corner, axis] : cells_a.edges) {
        if (!cells_b.edges.contains({corner, axis})) continue;
        Corner other = corner;
        (axis == 0 ? std::get<0>(other) : axis == 1 ? std::get<1>(other) : std::get<2>(other)) += 1;
        const Corner ra = root(corner);
        const Corner rb = root(other);
        if (ra == rb) continue;
        parent[ra] = rb;
        --count;
    }
    return count;
}

}  // namespace ossuary::skeleton
