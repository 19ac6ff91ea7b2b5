#include "engine/voxel/thin_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/voxel/morphology.h"
#include "engine/voxel/simple_point.h"

namespace ossuary {
namespace {

/// Calls visit(Vec3i) for voxels along the segment, at most half a voxel apart, ends included.
template <typename Visit>
void for_each_voxel_on(const GridMesh& mesh, const GridPoint& a, const GridPoint& b,
                       Visit&& visit) {
    std::int64_t longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        longest = std::max<std::int64_t>(longest, std::abs(b[i] - a[i]));
    }
    const std::int64_t steps = longest / kGridHalf + 1;
    for (std::int64_t s = 0; s <= steps; ++s) {
        GridPoint p;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = a[i] + static_cast<std::int32_t>((b[i] - a[i]) * s / steps);
        }
        visit(mesh.voxel_of(p));
    }
}

/// Calls visit(Vec3i) for the voxels of all points and of all edges longer than a voxel. (Shorter
/// ones lead from a voxel to one of its neighbours.)
template <typename Visit>
void for_each_edge_voxel(const GridMesh& mesh, Visit&& visit) {
    for (const GridPoint& p : mesh.points) visit(mesh.voxel_of(p));
    const auto edge = [&](std::uint32_t i, std::uint32_t k) {
        // In a fixed direction, so that the voxels do not depend on the order of the corners.
        const GridPoint& a = std::min(mesh.points[i], mesh.points[k]);
        const GridPoint& b = std::max(mesh.points[i], mesh.points[k]);
        bool is_long = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            is_long = is_long || std::abs(b[axis] - a[axis]) > kGridOne;
        }
        if (is_long) for_each_voxel_on(mesh, a, b, visit);
    };
    for (const auto& t : mesh.triangles) {
        edge(t[0], t[1]);
        edge(t[1], t[2]);
        edge(t[2], t[0]);
    }
    for (const auto& s : mesh.collapsed) edge(s[0], s[1]);
}

void unite(BitVolume& to, const BitVolume& from) {
    for (std::size_t w = 0; w < to.words().size(); ++w) to.words()[w] |= from.words()[w];
}

/// Removes the candidates that are simple points, again and again until none is.
void peel(std::vector<Vec3i> candidates, BitVolume& volume) {
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
}

}  // namespace

std::size_t add_thin_parts(const GridMesh& mesh, const BitVolume& thin, BitVolume& volume) {
    const BitVolume solid = volume;
    BitVolume touching = dilate(solid);
    unite(volume, thin);

    // Edges far from everything, then the edge voxels that tie them to it.
    BitVolume near = dilate(volume);
    BitVolume lost(volume.size());
    bool any_lost = false;
    for_each_edge_voxel(mesh, [&](const Vec3i& v) {
        if (near.test(v)) return;
        lost.set(v);
        any_lost = true;
    });
    if (any_lost) {
        const BitVolume around = dilate(lost);
        for_each_edge_voxel(mesh, [&](const Vec3i& v) {
            if (around.test(v)) volume.set(v);
        });
    }

    std::vector<Vec3i> candidates;
    for (int z = 0; z < volume.size().z(); ++z) {
        for (int y = 0; y < volume.size().y(); ++y) {
            const auto row = volume.row(y, z);
            const auto solid_row = solid.row(y, z);
            const auto touching_row = touching.row(y, z);
            for (std::size_t w = 0; w < row.size(); ++w) {
                std::uint64_t word = row[w] & touching_row[w] & ~solid_row[w];
                for (; word != 0; word &= word - 1) {
                    candidates.emplace_back(static_cast<int>(w * 64) + std::countr_zero(word), y,
                                            z);
                }
            }
        }
    }
    peel(std::move(candidates), volume);
    return volume.count() - solid.count();
}

}  // namespace ossuary
