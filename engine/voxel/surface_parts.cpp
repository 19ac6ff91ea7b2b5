#include "engine/voxel/surface_parts.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "engine/mesh/disjoint_sets.h"
#include "engine/voxel/boundary_sum.h"

namespace ossuary::voxel {
namespace {

using Kind = SurfaceParts::Kind;
using Triangle = GridMesh::Triangle;

Kind kind_of(const BoundarySum& sum) {
    return sum.oriented == 0 ? Kind::kOriented : (sum.parity == 0 ? Kind::kEven : Kind::kOpen);
}

/// For each of some triangles the group that it is in, and the number of groups.
struct Grouping {
    std::vector<std::uint32_t> group;
    std::uint32_t count = 0;
};

/// Groups triangles by shared points.
Grouping group_by_points(const GridMesh& mesh, std::span<const std::uint32_t> triangles) {
    // Handing the least index around, there and back, settles most points without a guess: half of
    // the time that union-find alone takes, three quarters for the armadillo.
    std::vector<std::uint32_t> least(mesh.points.size());
    std::iota(least.begin(), least.end(), 0u);
    const auto hand_around = [&](std::uint32_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::uint32_t l = std::min(std::min(least[a], least[b]), least[c]);
        least[a] = least[b] = least[c] = l;
    };
    for (const std::uint32_t t : triangles) hand_around(t);
    for (std::size_t i = triangles.size(); i-- > 0;) hand_around(triangles[i]);
    mesh::DisjointSets sets(std::move(least));
    for (const std::uint32_t t : triangles) {
        const auto& [a, b, c] = mesh.triangles[t];
        sets.unite(a, b);
        sets.unite(a, c);
    }
    const std::vector<std::uint32_t> set_of = sets.representatives();
    const auto is_first = [](std::uint32_t set) { return set == 0; };
    if (!triangles.empty() && std::all_of(set_of.begin(), set_of.end(), is_first)) {
        return {std::vector<std::uint32_t>(triangles.size(), 0), 1};
    }
    constexpr std::uint32_t kUnnumbered = 0xFFFFFFFFu;
    std::vector<std::uint32_t> number(mesh.points.size(), kUnnumbered);
    Grouping result;
    result.group.reserve(triangles.size());
    for (const std::uint32_t t : triangles) {
        std::uint32_t& n = number[set_of[mesh.triangles[t][0]]];
        if (n == kUnnumbered) n = result.count++;
        result.group.push_back(n);
    }
    return result;
}

/// The boundary of each group.
std::vector<BoundarySum> sum_up(const GridMesh& mesh, std::span<const std::uint32_t> triangles,
                                const Grouping& groups) {
    const std::vector<std::uint64_t> keys = point_keys(mesh.points.size());
    std::vector<BoundarySum> sums(groups.count);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        sums[groups.group[i]].add(mesh.triangles[triangles[i]], keys);
    }
    return sums;
}

struct Side {
    std::uint32_t a, b;   ///< smaller and larger point
    std::uint32_t index;  ///< of the triangle among those looked at
    bool up;              ///< runs from a to b
};

/// The patches of a piece: connected across edges of exactly two triangles, turned to agree.
Grouping orient_patches(GridMesh& mesh, std::span<const std::uint32_t> triangles) {
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
    const Grouping patches = orient_patches(mesh, triangles);
    const auto& [patch, patch_count] = patches;
    const std::vector<BoundarySum> sums = sum_up(mesh, triangles, patches);
    const auto first_part = static_cast<std::uint32_t>(parts.count());
    std::vector<std::uint32_t> part_of_patch(patch_count, 0);
    for (std::uint32_t p = 0; p < patch_count; ++p) {
        if (kind_of(sums[p]) == Kind::kOpen) continue;
        part_of_patch[p] = static_cast<std::uint32_t>(parts.count());
        parts.kinds.push_back(kind_of(sums[p]));
    }
    std::vector<std::uint32_t> rest;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (part_of_patch[patch[i]] >= first_part && kind_of(sums[patch[i]]) != Kind::kOpen) {
            parts.part_of[triangles[i]] = part_of_patch[patch[i]];
        } else {
            rest.push_back(triangles[i]);
        }
    }
    // Patches that close only together, by parity, or not at all.
    const Grouping groups = group_by_points(mesh, rest);
    const std::vector<BoundarySum> group_sums = sum_up(mesh, rest, groups);
    const auto base = static_cast<std::uint32_t>(parts.count());
    for (const BoundarySum& sum : group_sums) {
        parts.kinds.push_back(sum.parity == 0 ? Kind::kEven : Kind::kOpen);
    }
    for (std::size_t i = 0; i < rest.size(); ++i) {
        parts.part_of[rest[i]] = base + groups.group[i];
        if (parts.kinds[base + groups.group[i]] == Kind::kOpen) ++parts.open_triangles;
    }
}

}  // namespace

SurfaceParts find_parts(GridMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    Grouping groups = group_by_points(mesh, all);
    SurfaceParts parts;
    if (mesh.closed) {
        parts.kinds.assign(groups.count, Kind::kOriented);
        parts.part_of = std::move(groups.group);
        return parts;
    }
    const std::vector<BoundarySum> sums = sum_up(mesh, all, groups);
    parts.part_of.resize(all.size());
    std::vector<std::uint32_t> part_of_group(groups.count, 0);
    for (std::uint32_t g = 0; g < groups.count; ++g) {
        if (kind_of(sums[g]) != Kind::kOriented) continue;
        part_of_group[g] = static_cast<std::uint32_t>(parts.count());
        parts.kinds.push_back(Kind::kOriented);
    }
    std::vector<std::uint32_t> open;
    for (const std::uint32_t t : all) {
        const std::uint32_t group = groups.group[t];
        if (kind_of(sums[group]) == Kind::kOriented) {
            parts.part_of[t] = part_of_group[group];
        } else {
            open.push_back(t);
        }
    }
    if (!open.empty()) split_open_pieces(mesh, open, parts);
    return parts;
}

}  // namespace ossuary::voxel
