#include "engine/chain_code/orthogonalize.h"

#include <cassert>
#include <cmath>

#include "engine/chain_code/five_element_code.h"

namespace ossuary::chain_code {
namespace {

Vec3i voxel_of(const Vec3& point) {
    return {static_cast<int>(std::floor(point.x())), static_cast<int>(std::floor(point.y())),
            static_cast<int>(std::floor(point.z()))};
}

/// The voxels that the points lie in, without repetitions; points more than a voxel apart are
/// joined by evenly spaced ones between, so that neighbours in the result touch.
std::vector<Vec3i> voxels_along(std::span<const Vec3> polyline) {
    std::vector<Vec3i> voxels = {voxel_of(polyline[0])};
    for (std::size_t i = 1; i < polyline.size(); ++i) {
        const Vec3 step = polyline[i] - polyline[i - 1];
        const int parts = std::max(1, static_cast<int>(std::ceil(step.cwiseAbs().maxCoeff())));
        for (int k = 1; k <= parts; ++k) {
            const Vec3i voxel = voxel_of(polyline[i - 1] + step * (k / static_cast<double>(parts)));
            if (voxel != voxels.back()) voxels.push_back(voxel);
        }
    }
    return voxels;
}

/// A path under construction with the two differing directions that it last went.
struct Walk {
    std::vector<Vec3i> path;
    Vec3i b = Vec3i::Zero();
    Vec3i c = Vec3i::Zero();

    void step(const Vec3i& d) {
        if (!c.isZero() && d == -c) {
            path.pop_back();
            recall_directions();
            return;
        }
        path.push_back(path.back() + d);
        if (d != c) {
            b = c;
            c = d;
        }
    }

    void recall_directions() {
        b = c = Vec3i::Zero();
        for (std::size_t i = path.size(); i-- > 1;) {
            const Vec3i d = path[i] - path[i - 1];
            if (c.isZero()) {
                c = d;
            } else if (d != c) {
                b = d;
                break;
            }
        }
    }
};

/// The unit step on from the end of `walk` towards `remaining` with the highest descriptor.
Vec3i choose_step(const Walk& walk, const Vec3i& remaining, const Vec3i& whole) {
    Vec3i best = Vec3i::Zero();
    int best_value = -2;
    int best_reach = -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (remaining[axis] == 0) continue;
        Vec3i d = Vec3i::Zero();
        d[axis] = remaining[axis] > 0 ? 1 : -1;
        int value = 0;
        if (!walk.c.isZero()) value = d == -walk.c ? -1 : chain_element(walk.b, walk.c, d) - '0';
        const int reach = std::abs(whole[axis]);
        if (value > best_value || (value == best_value && reach > best_reach)) {
            best = d;
            best_value = value;
            best_reach = reach;
        }
    }
    assert(!best.isZero());
    return best;
}

}  // namespace

std::vector<Vec3i> orthogonalize(std::span<const Vec3> polyline) {
    assert(!polyline.empty());
    const std::vector<Vec3i> voxels = voxels_along(polyline);
    const Vec3i whole = voxels.back() - voxels.front();
    Walk walk;
    walk.path.push_back(voxels.front());
    for (std::size_t i = 1; i < voxels.size(); ++i) {
        Vec3i remaining = voxels[i] - voxels[i - 1];
        while (!remaining.isZero()) {
            const Vec3i d = choose_step(walk, remaining, whole);
            walk.step(d);
            remaining -= d;
        }
    }
    return std::move(walk.path);
}

}  // namespace ossuary::chain_code
