#include "engine/voxel/wrap_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nanoflann.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/components.h"
#include "engine/voxel/distance_transform.h"
#include "engine/voxel/level_surface.h"
#include "engine/voxel/point_set.h"
#include "engine/voxel/scalar_grid.h"

namespace ossuary::voxel {
namespace {

constexpr std::size_t kPointsBetweenLooks = 4096;

/// Where points are spread at random over a surface, the largest gap between 5,000 has 1.8 times
/// the radius in which one point is to be expected; the 95th percentile of the distance to the
/// sixth nearest is the same. On a regular grid it is 1.4 times its side.
constexpr std::size_t kNeighbours = 6;
constexpr double kPercentile = 0.95;
/// Points whose sixth nearest is so many times as far away as that do not count.
constexpr double kStray = 3.0;
/// Further radii that are tried, over the first.
constexpr std::array kWider = {1.25, 1.6};
/// Grid points to the balls' radius.
constexpr double kRadiusVoxels = 3.0;

using PointTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointSet>, PointSet, 3,
                                        std::size_t>;

Error wrapping_cancelled() { return {ErrorCode::kCancelled, "wrapping points: stopped"}; }

Box3 box_of(const std::vector<Vec3>& points) {
    Box3 box;
    for (const Vec3& point : points) box.extend(point);
    return box;
}

/// One point for all that lie in the same cell of a grid finer than the result's, in the order of
/// the cells: less noise, and no more points than cells however large the set.
std::vector<Vec3> thin_out(const std::vector<Vec3>& points, double cell) {
    const Vec3 low = box_of(points).min();
    std::vector<std::pair<std::array<std::int32_t, 3>, Vec3>> placed;
    placed.reserve(points.size());
    for (const Vec3& point : points) {
        const Vec3 at = (point - low) / cell;
        placed.push_back({{static_cast<std::int32_t>(at.z()), static_cast<std::int32_t>(at.y()),
                           static_cast<std::int32_t>(at.x())},
                          point});
    }
    // By position within a cell, so that sums are the same in any order.
    std::sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
        return std::tuple(a.first, a.second.x(), a.second.y(), a.second.z()) <
               std::tuple(b.first, b.second.x(), b.second.y(), b.second.z());
    });
    std::vector<Vec3> thinned;
    for (std::size_t begin = 0; begin < placed.size();) {
        std::size_t end = begin;
        Vec3 sum = Vec3::Zero();
        for (; end < placed.size() && placed[end].first == placed[begin].first; ++end) {
            sum += placed[end].second - low;
        }
        thinned.push_back(low + sum / static_cast<double>(end - begin));
        begin = end;
    }
    return thinned;
}

/// Distances from each point to its nearest other one and to its sixth.
struct Neighbourhood {
    std::vector<double> nearest;
    std::vector<double> sixth;
};

Result<Neighbourhood> look_around(const std::vector<Vec3>& points, const std::stop_token& stop) {
    const PointSet set{points};
    PointTree tree(3, set);
    tree.buildIndex();
    Neighbourhood found;
    std::array<std::size_t, kNeighbours + 1> indices{};
    std::array<double, kNeighbours + 1> squared{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % kPointsBetweenLooks == 0 && stop.stop_requested()) return wrapping_cancelled();
        tree.knnSearch(points[i].data(), indices.size(), indices.data(), squared.data());
        found.nearest.push_back(std::sqrt(squared[1]));
        found.sixth.push_back(std::sqrt(squared[kNeighbours]));
    }
    return found;
}

double percentile(std::vector<double> values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

/// The grid that points are laid into, with room around for the balls.
struct Lattice {
    Vec3 low;      ///< of the voxel (0, 0, 0)'s centre
    double voxel;  ///< world units
    int reach;     ///< of the balls, voxels, rounded up
    Vec3i size;

    Lattice(const Box3& box, double side, double radius)
        : voxel(side), reach(static_cast<int>(std::ceil(radius / side))) {
        // What lies outside counts as a point for distances, so that balls grow in from the border.
        const int margin = 2 * reach + 3;
        low = box.min() - Vec3::Constant(margin * voxel);
        for (int axis = 0; axis < 3; ++axis) {
            size[axis] = static_cast<int>(std::lround(box.sizes()[axis] / voxel)) + 1 + 2 * margin;
        }
    }
    [[nodiscard]] Vec3i voxel_of(const Vec3& point) const {
        const Vec3 at = (point - low) / voxel;
        return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())),
                static_cast<int>(std::lround(at.z()))};
    }
};

/// How far each voxel is from the nearest point; on the border, from what lies outside.
DistanceField distances_to(const std::vector<Vec3>& points, const Lattice& lattice,
                           const std::stop_token& stop) {
    BitVolume between(lattice.size);
    for (int z = 0; z < lattice.size.z(); ++z) {
        for (int y = 0; y < lattice.size.y(); ++y) set_run(between, {0, lattice.size.x(), y, z, 0});
    }
    for (const Vec3& point : points) between.reset(lattice.voxel_of(point));
    return distance_transform(between, stop);
}

/// The balls around all points, and what they shut in.
struct Balls {
    BitVolume filled;
    std::size_t shut_in = 0;  ///< voxels in no ball
    double radius_voxels = 0.0;
};

Balls blow_up(const DistanceField& distance, const Lattice& lattice, double radius_voxels) {
    Balls balls{BitVolume(lattice.size), 0, radius_voxels};
    const double squared = radius_voxels * radius_voxels;
    const int border = lattice.reach + 1;
    for (int z = border; z + border < lattice.size.z(); ++z) {
        for (int y = border; y + border < lattice.size.y(); ++y) {
            for (int x = border; x + border < lattice.size.x(); ++x) {
                if (static_cast<double>(distance.squared({x, y, z})) <= squared) {
                    balls.filled.set(x, y, z);
                }
            }
        }
    }
    balls.shut_in = fill_cavities(balls.filled).voxels;
    return balls;
}

/// Larger balls leave less between them, unless smaller ones had let the outside in: the radius
/// that shuts in most is the right one. Four of 200 benchmark models of 5,000 points leak at the
/// first.
Balls without_leak(const DistanceField& distance, const Lattice& lattice, double radius_voxels,
                   const std::stop_token& stop) {
    Balls best = blow_up(distance, lattice, radius_voxels);
    for (const double factor : kWider) {
        if (stop.stop_requested()) break;
        Balls wider = blow_up(distance, lattice, factor * radius_voxels);
        if (wider.shut_in > best.shut_in) best = std::move(wider);
    }
    return best;
}

/// How far each voxel is from what is not shut in, in voxels.
ScalarGrid depths(const BitVolume& filled, const Lattice& lattice, const std::stop_token& stop) {
    const DistanceField distance = distance_transform(filled, stop);
    ScalarGrid grid(lattice.size);
    grid.origin = lattice.low;
    grid.axes = Mat3::Identity() * lattice.voxel;
    for_each_voxel(filled, [&](const Vec3i& voxel) {
        grid.at(voxel.x(), voxel.y(), voxel.z()) = static_cast<float>(distance.distance(voxel));
    });
    return grid;
}

Error too_few(std::size_t found, const WrapOptions& options) {
    return {ErrorCode::kPointsTooFew,
            "expected faces, or at least " + std::to_string(options.min_points) +
                " different points, found no face and " + std::to_string(found)};
}

}  // namespace

Result<WrappedPoints> wrap_points(const std::vector<Vec3>& points, const WrapOptions& options,
                                  const std::stop_token& stop) {
    if (points.size() < options.min_points) return too_few(points.size(), options);
    const double extent = box_of(points).sizes().maxCoeff();
    if (!(extent > 0)) return {ErrorCode::kMeshNoExtent, "all points coincide"};
    const double finest = extent / (options.max_side - 1);
    std::vector<Vec3> set = thin_out(points, finest / 2);
    if (set.size() < options.min_points) return too_few(set.size(), options);
    const Result<Neighbourhood> around = look_around(set, stop);
    if (!around) return around.error();

    WrappedPoints wrapped;
    wrapped.spacing = percentile(around->nearest, 0.5);
    const double reach = percentile(around->sixth, kPercentile);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (around->sixth[i] <= kStray * reach) set[kept++] = set[i];
    }
    wrapped.stray_points = set.size() - kept;
    set.resize(kept);

    const double voxel = std::max(finest, reach / kRadiusVoxels);
    wrapped.radius = std::max(reach, 2 * voxel);
    const Lattice lattice(box_of(set), voxel, kWider.back() * wrapped.radius);
    const DistanceField distance = distances_to(set, lattice, stop);
    if (stop.stop_requested()) return wrapping_cancelled();
    const Balls balls = without_leak(distance, lattice, wrapped.radius / voxel, stop);
    wrapped.radius = balls.radius_voxels * voxel;
    if (stop.stop_requested()) return wrapping_cancelled();
    const ScalarGrid grid = depths(balls.filled, lattice, stop);
    if (stop.stop_requested()) return wrapping_cancelled();
    wrapped.mesh = level_surface(grid, static_cast<float>(balls.radius_voxels), stop);
    if (stop.stop_requested()) return wrapping_cancelled();
    return wrapped;
}

}  // namespace ossuary::voxel
