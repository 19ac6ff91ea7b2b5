#include "engine/registration/closest_points.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace ossuary::registration {
namespace {

using Vec7 = Eigen::Matrix<double, 7, 1>;
using Mat7 = Eigen::Matrix<double, 7, 7>;

constexpr double kPointWeight = 0.05;  ///< of a point's own distance beside that to the plane
constexpr double kFacing = 0.3;        ///< least cosine between normals of a pair
constexpr double kBeyondMost = 3.0;    ///< reach over the median distance

struct Pair {
    Vec3 moved, onto, normal;
    double distance = 0.0;
};

std::vector<Pair> pairs_within(const SurfacePoints& source, const SurfacePoints& target,
                               const NearestPoint& nearest, const Similarity& placement,
                               double reach) {
    std::vector<Pair> pairs;
    pairs.reserve(source.points.size());
    for (std::size_t i = 0; i < source.points.size(); ++i) {
        const Vec3 moved = placement.point(source.points[i]);
        const NearestPoint::Found found = nearest.of(moved);
        const double distance = std::sqrt(found.squared_distance);
        if (!(distance <= reach)) continue;
        const Vec3& normal = target.normals[found.index];
        if (placement.normal(source.normals[i]).dot(normal) < kFacing) continue;
        pairs.push_back({moved, target.points[found.index], normal, distance});
    }
    return pairs;
}

/// The small motion (turn, translation, relative growth; about `center`, in units of `size`) that
/// solves the linearised problem.
Vec7 solve(const std::vector<Pair>& pairs, const Vec3& center, double size, bool scale) {
    Mat7 normal_matrix = Mat7::Zero();
    Vec7 right = Vec7::Zero();
    const auto add = [&](const Vec3& direction, const Vec3& x, double residual, double weight) {
        Vec7 row;
        row << x.cross(direction), direction, scale ? direction.dot(x) : 0.0;
        normal_matrix += weight * row * row.transpose();
        right += weight * residual * row;
    };
    for (const Pair& pair : pairs) {
        const Vec3 x = (pair.moved - center) / size;
        const Vec3 gap = (pair.onto - pair.moved) / size;
        add(pair.normal, x, pair.normal.dot(gap), 1.0);
        for (int axis = 0; axis < 3; ++axis) {
            add(Vec3::Unit(axis), x, gap[axis], kPointWeight);
        }
    }
    normal_matrix.diagonal().array() += 1e-9 * (1.0 + static_cast<double>(pairs.size()));
    return normal_matrix.ldlt().solve(right);
}

Similarity moved_by(const Vec7& motion, const Vec3& center, double size) {
    Similarity step;
    const Vec3 turn = motion.head<3>();
    if (turn.norm() > 0.0) {
        step.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    }
    step.scale = std::exp(std::clamp(motion[6], -0.2, 0.2));
    step.translation = center + size * motion.segment<3>(3) - step.scale * (step.rotation * center);
    return step;
}

double median_distance(std::vector<Pair>& pairs) {
    const auto middle = pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 2);
    std::nth_element(pairs.begin(), middle, pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    return middle->distance;
}

}  // namespace

Refined refine(const SurfacePoints& source, const SurfacePoints& target,
               const NearestPoint& nearest, const Similarity& start, const RefineOptions& options) {
    Refined refined{start};
    double reach = options.reach * target.diagonal;
    // Points of two samplings lie apart however well the surfaces meet.
    const double spacing = std::sqrt(
        target.area / static_cast<double>(std::max<std::size_t>(1, target.points.size())));
    const double least_reach = std::max(options.least_reach * target.diagonal, spacing);
    for (int iteration = 0; iteration <= options.iterations; ++iteration) {
        auto pairs = pairs_within(source, target, nearest, refined.placement, reach);
        if (pairs.size() < 7) return refined;
        refined.share =
            static_cast<double>(pairs.size()) / static_cast<double>(source.points.size());
        refined.mean_distance = 0.0;
        Vec3 center = Vec3::Zero();
        for (const Pair& pair : pairs) {
            refined.mean_distance += std::abs(pair.normal.dot(pair.onto - pair.moved)) /
                                     static_cast<double>(pairs.size());
            center += pair.moved / static_cast<double>(pairs.size());
        }
        if (iteration == options.iterations) break;
        const Vec7 motion = solve(pairs, center, target.diagonal, options.scale);
        if (!motion.allFinite()) return refined;
        refined.placement = compose(moved_by(motion, center, target.diagonal), refined.placement);
        reach = std::clamp(kBeyondMost * median_distance(pairs), least_reach, reach);
        if (motion.norm() < 1e-7) break;
    }
    return refined;
}

}  // namespace ossuary::registration
