#include "engine/voxel/surface_parts.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "engine/mesh/disjoint_sets.h"

namespace ossuary {
namespace {

using Kind = SurfaceParts::Kind;
using Triangle = GridMesh::Triangle;

/// A pseudo-random number for an undirected edge.
std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    std::uint64_t x = (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
    x = (x + 0x9E3779B97F4A7C15u) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 31)) * 0x94D049BB133111EBu;
    return x ^ (x >> 30);
}

/// The boundary of a set of triangles as a sum over edges of pseudo-random numbers: 0 when every
/// edge is run along as often one way as the other (`oriented`) or an even number of times
/// (`parity`), and otherwise not 0 but for one chance in 2^64. Takes a tenth of the time of
/// matching edges.
struct BoundarySum {
    std::uint64_t oriented = 0;
    std::uint64_t parity = 0;

    void add(const Triangle& t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i];
            const std::uint32_t b = t[i == 2 ? 0 : i + 1];
            const std::uint64_t key = edge_key(a, b);
            oriented += a < b ? key : ~key + 1;
            parity ^= key;
        }
    }
    [[nodiscard]] Kind kind() const {
        return oriented == 0 ? Kind::kOriented : (parity == 0 ? Kind::kEven : Kind::kOpen);
    }
};

/// Groups `triangles` by shared points; returns the group of each and the number of groups.
std::pair<std::vector<std::uint32_t>, std::uint32_t> group_by_points(
    const GridMesh& mesh, std::span<const std::uint32_t> triangles) {
    DisjointSets sets(mesh.points.size());
    for (const std::uint32_t t : triangles) {
        sets.unite(mesh.triangles[t][0], mesh.triangles[t][1]);
        sets.unite(mesh.triangles[t][0], mesh.triangles[t][2]);
    }
    constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    std::vector<std::uint32_t> number(mesh.points.size(), kNone);
    std::vector<std::uint32_t> group(triangles.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        std::uint32_t& n = number[sets.find(mesh.triangles[triangles[i]][0])];
        if (n == kNone) n = count++;
        group[i] = n;
    }
    return {std::move(group), count};
}

struct Side {
    std::uint32_t a, b;   ///< smaller and larger point
    std::uint32_t index;  ///< of the triangle among those looked at
    bool up;              ///< runs from a to b
};

/// The patches of a piece: connected across edges of exactly two triangles, turned to agree.
/// Returns the patch of each triangle and their number.
std::pair<std::vector<std::uint32_t>, std::uint32_t> orient_patches(
    GridMesh& mesh, std::span<const std::uint32_t> triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[triangles[i]];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), i, a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
        return s.a != t.a ? s.a < t.a : (s.b != t.b ? s.b < t.b : s.index < t.index);
    });
    // Union-find with the parity of turns along the way to the root.
    std::vector<std::uint32_t> parent(triangles.size());
    std::vector<std::uint8_t> turn(triangles.size(), 0);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto find = [&](std::uint32_t i) {
        std::uint8_t turned = 0;
        while (parent[i] != i) {
            turn[i] = static_cast<std::uint8_t>(turn[i] ^ turn[parent[i]]);  // 0 at roots
            parent[i] = parent[parent[i]];
            turned = static_cast<std::uint8_t>(turned ^ turn[i]);
            i = parent[i];
        }
        return std::pair(i, turned);
    };
    for (std::size_t begin = 0; begin < sides.size();) {
        std::size_t end = begin + 1;
        while (end < sides.size() && sides[end].a == sides[begin].a &&
               sides[end].b == sides[begin].b) {
            ++end;
        }
        if (end - begin == 2) {
            const auto [i, turned_i] = find(sides[begin].index);
            const auto [j, turned_j] = find(sides[begin + 1].index);
            if (i != j) {
                const bool disagree = sides[begin].up == sides[begin + 1].up;
                parent[std::max(i, j)] = std::min(i, j);
                turn[std::max(i, j)] =
                    static_cast<std::uint8_t>(turned_i ^ turned_j ^ (disagree ? 1 : 0));
            }
        }
        begin = end;
    }
    std::vector<std::uint32_t> patch(triangles.size());
    std::vector<std::uint32_t> number(triangles.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto [root, turned] = find(i);
        if (root == i) number[i] = count++;
        patch[i] = number[root];
        if (turned != 0)
            std::swap(mesh.triangles[triangles[i]][1], mesh.triangles[triangles[i]][2]);
    }
    return {std::move(patch), count};
}

/// Sorts out the pieces that are not closed as they came.
void split_open_pieces(GridMesh& mesh, const std::vector<std::uint32_t>& triangles,
                       SurfaceParts& parts) {
    const auto [patch, patch_count] = orient_patches(mesh, triangles);
    std::vector<BoundarySum> sums(patch_count);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        sums[patch[i]].add(mesh.triangles[triangles[i]]);
    }
    const auto first_part = static_cast<std::uint32_t>(parts.count());
    std::vector<std::uint32_t> part_of_patch(patch_count, 0);
    for (std::uint32_t p = 0; p < patch_count; ++p) {
        if (sums[p].kind() == Kind::kOpen) continue;
        part_of_patch[p] = static_cast<std::uint32_t>(parts.count());
        parts.kinds.push_back(sums[p].kind());
    }
    std::vector<std::uint32_t> rest;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (part_of_patch[patch[i]] >= first_part && sums[patch[i]].kind() != Kind::kOpen) {
            parts.part_of[triangles[i]] = part_of_patch[patch[i]];
        } else {
            rest.push_back(triangles[i]);
        }
    }
    // Patches that close only together, by parity, or not at all.
    const auto [group, group_count] = group_by_points(mesh, rest);
    std::vector<BoundarySum> group_sums(group_count);
    for (std::size_t i = 0; i < rest.size(); ++i) group_sums[group[i]].add(mesh.triangles[rest[i]]);
    const auto base = static_cast<std::uint32_t>(parts.count());
    for (const BoundarySum& sum : group_sums) {
        parts.kinds.push_back(sum.parity == 0 ? Kind::kEven : Kind::kOpen);
    }
    for (std::size_t i = 0; i < rest.size(); ++i) {
        parts.part_of[rest[i]] = base + group[i];
        if (parts.kinds[base + group[i]] == Kind::kOpen) ++parts.open_triangles;
    }
}

}  // namespace

SurfaceParts find_parts(GridMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    const auto [group, group_count] = group_by_points(mesh, all);
    std::vector<BoundarySum> sums(group_count);
    for (std::size_t t = 0; t < all.size(); ++t) sums[group[t]].add(mesh.triangles[t]);

    SurfaceParts parts;
    parts.part_of.resize(all.size());
    std::vector<std::uint32_t> part_of_group(group_count, 0);
    for (std::uint32_t g = 0; g < group_count; ++g) {
        if (sums[g].kind() != Kind::kOriented) continue;
        part_of_group[g] = static_cast<std::uint32_t>(parts.count());
        parts.kinds.push_back(Kind::kOriented);
    }
    std::vector<std::uint32_t> open;
    for (std::uint32_t t = 0; t < all.size(); ++t) {
        if (sums[group[t]].kind() == Kind::kOriented) {
            parts.part_of[t] = part_of_group[group[t]];
        } else {
            open.push_back(t);
        }
    }
    if (!open.empty()) split_open_pieces(mesh, open, parts);
    return parts;
}

}  // namespace ossuary
