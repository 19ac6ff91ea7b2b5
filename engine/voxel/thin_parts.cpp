#include "engine/voxel/thin_parts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "engine/voxel/morphology.h"
#include "engine/voxel/simple_point.h"
#include "engine/voxel/thin_lines.h"

namespace ossuary::voxel {
namespace {

/// Calls visit(Vec3i) for the voxels of places between two points that are at most `spacing` apart.
/// Returns their number.
template <typename Visit>
std::uint64_t for_each_between(const GridMesh& mesh, std::uint32_t i, std::uint32_t k,
                               std::int32_t spacing, Visit&& visit) {
    // In a fixed direction, so that the voxels do not depend on the order of the corners.
    const bool forward = mesh.points[i] < mesh.points[k];
    const GridPoint& a = mesh.points[forward ? i : k];
    const GridPoint& b = mesh.points[forward ? k : i];
    std::int32_t longest = 0;
    for (std::size_t x = 0; x < 3; ++x) longest = std::max(longest, std::abs(b[x] - a[x]));
    const std::int32_t steps = (longest + spacing - 1) / spacing;
    // a + (b - a) * s / steps, rounded towards a, without its divisions.
    GridPoint p = a, whole, rest, sign, sum{};
    for (std::size_t x = 0; x < 3; ++x) {
        whole[x] = (b[x] - a[x]) / steps;
        rest[x] = std::abs((b[x] - a[x]) % steps);
        sign[x] = b[x] > a[x] ? 1 : -1;
    }
    for (std::int32_t s = 1; s < steps; ++s) {
        for (std::size_t x = 0; x < 3; ++x) {
            sum[x] += rest[x];
            const std::int32_t carry = sum[x] >= steps ? 1 : 0;
            sum[x] -= steps & -carry;
            p[x] += whole[x] + carry * sign[x];
        }
        visit(mesh.voxel_of(p));
    }
    return static_cast<std::uint64_t>(steps);
}

/// Calls visit(Vec3i) for the voxels of the triangles' corners, and of places along their edges and
/// along collapsed triangles that are at most `spacing` apart, until the meter says so.
template <typename Visit>
void for_each_edge_voxel(const GridMesh& mesh, const std::vector<std::uint32_t>& triangles,
                         std::int32_t spacing, CastMeter& meter, Visit&& visit) {
    std::vector<std::uint8_t> seen(mesh.points.size(), 0);
    const auto point = [&](std::uint32_t i) {
        if (seen[i] == 0) visit(mesh.voxel_of(mesh.points[i]));
        seen[i] = 1;
    };
    const auto edge = [&](std::uint32_t i, std::uint32_t k) {
        const GridPoint& a = mesh.points[i];
        const GridPoint& b = mesh.points[k];
        std::int32_t longest = 0;
        for (std::size_t x = 0; x < 3; ++x) longest = std::max(longest, std::abs(a[x] - b[x]));
        // The other triangle at a long edge runs along it the other way.
        if (longest <= spacing || (mesh.closed && i > k && longest > kLongEdge)) return;
        meter.count_steps(for_each_between(mesh, i, k, spacing, visit));
    };
    for (const std::uint32_t index : triangles) {
        if (!meter.count_steps(1)) return;
        const GridMesh::Triangle& t = mesh.triangles[index];
        for (std::size_t x = 0; x < 3; ++x) {
            point(t[x]);
            edge(t[x], t[x == 2 ? 0 : x + 1]);
        }
    }
    for (const auto& s : mesh.collapsed) {
        if (!meter.count_steps(1)) return;
        point(s[0]);
        point(s[1]);
        edge(s[0], s[1]);
    }
}

/// Whether a voxel or one of its 26 neighbours is set. @pre not in the outermost layer
bool is_near(const BitVolume& volume, const Vec3i& v) {
    if (volume.test(v)) return true;
    const int x = v.x() - 1;
    const auto word = static_cast<std::size_t>(x >> 6);
    const int bit = x & 63;
    std::uint64_t any = 0;
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
            const auto row = volume.row(v.y() + dy, v.z() + dz);
            any |= row[word] >> bit;
            if (bit > 61 && word + 1 < row.size()) any |= row[word + 1] << (64 - bit);
        }
    }
    return (any & 7) != 0;
}

/// In the order of the grid, each once, so that the outcome does not depend on the mesh's order.
void sort_and_unite(std::vector<Vec3i>& voxels) {
    std::sort(voxels.begin(), voxels.end(), [](const Vec3i& a, const Vec3i& b) {
        return a.z() != b.z() ? a.z() < b.z() : (a.y() != b.y() ? a.y() < b.y() : a.x() < b.x());
    });
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
}

/// Removes the candidates that are simple points, again and again until none is. Returns how many.
std::size_t peel(std::vector<Vec3i> candidates, BitVolume& volume) {
    const std::size_t all = candidates.size();
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Vec3i> left;
        for (const Vec3i& v : candidates) {
            if (is_simple_point(volume, v)) {
                volume.reset(v);
                changed = true;
            } else {
                left.push_back(v);
            }
        }
        candidates = std::move(left);
    }
    return all - candidates.size();
}

}  // namespace

std::size_t add_thin_parts(const GridMesh& mesh, const VoxelSet& thin,
                           const std::vector<std::uint32_t>& places, CastMeter& meter,
                           BitVolume& volume) {
    std::vector<Vec3i> added;
    thin.for_each([&](const Vec3i& v) {
        if (!volume.test(v)) added.push_back(v);
    });
    // Peeling whatever touches the volume, thick or not, ate wings of a fraction of a voxel down to
    // a web between the few voxels that their inside had hit: a third of a tilted plate was left.
    std::vector<Vec3i> candidates;
    for (const Vec3i& v : added) {
        if (is_near_thick_part(volume, v)) candidates.push_back(v);
    }
    for (const Vec3i& v : added) volume.set(v);
    VoxelSet lost(volume.size());
    // Growing takes some 3 ns a word; looking around at a triangle's corners and edges some 80.
    const bool grow = 32 * places.size() > volume.words().size();
    const BitVolume grown = grow ? dilate(volume) : BitVolume();
    for_each_edge_voxel(mesh, places, kGridOne, meter, [&](const Vec3i& v) {
        if (grow ? !grown.test(v) : !is_near(volume, v)) lost.add(v);
    });
    if (!lost.empty()) {
        // Lines through the lost places, up to where they touch something.
        BitVolume around(volume.size());
        lost.for_each([&](const Vec3i& v) { around.set(v); });
        around = dilate(around);
        VoxelSet drawn(volume.size());
        for_each_edge_voxel(mesh, places, kGridHalf, meter, [&](const Vec3i& v) {
            if (around.test(v) && !volume.test(v)) drawn.add(v);
        });
        drawn.for_each([&](const Vec3i& v) {
            if (is_near(volume, v)) candidates.push_back(v);
        });
        drawn.for_each([&](const Vec3i& v) {
            volume.set(v);
            added.push_back(v);
        });
    }
    sort_and_unite(candidates);
    sort_and_unite(added);
    if (meter.over()) return 0;
    return added.size() - peel(std::move(candidates), volume);
}

}  // namespace ossuary::voxel
