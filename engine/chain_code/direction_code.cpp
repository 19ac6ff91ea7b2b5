#include "engine/chain_code/direction_code.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ossuary::chain_code {
namespace {

constexpr double kSmallestRadius = 0.001;
/// Deviations below this share of the branch's extent say nothing about its frame.
constexpr double kFlat = 1e-4;

Vec3 any_perpendicular(const Vec3& x) {
    Eigen::Index axis = 0;
    x.cwiseAbs().minCoeff(&axis);
    return x.cross(Vec3::Unit(axis)).normalized();
}

/// Sum of the offsets of points [begin, end) from the line through `origin` along unit `x`.
Vec3 summed_deviation(std::span<const Vec3f> points, const Vec3& origin, const Vec3& x,
                      std::size_t begin, std::size_t end) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = begin; i < end; ++i) {
        const Vec3 offset = points[i].cast<double>() - origin;
        sum += offset - offset.dot(x) * x;
    }
    return sum;
}

}  // namespace

const std::array<Vec3f, kDirectionCount>& directions26() {
    static const std::array<Vec3f, kDirectionCount> directions = [] {
        std::array<Vec3f, kDirectionCount> all;
        std::size_t n = 0;
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dz = -1; dz <= 1; ++dz) {
                    if (dx == 0 && dy == 0 && dz == 0) continue;
                    all[n++] = Vec3i(dx, dy, dz).cast<float>().normalized();
                }
            }
        }
        return all;
    }();
    return directions;
}

std::uint8_t quantize_direction(const Vec3f& v) {
    assert(v.squaredNorm() > 0.0F);
    const auto& directions = directions26();
    std::size_t best = 0;
    for (std::size_t i = 1; i < directions.size(); ++i) {
        if (directions[i].dot(v) > directions[best].dot(v)) best = i;
    }
    return static_cast<std::uint8_t>(best);
}

std::uint8_t quantize_radius(double radius) {
    if (radius <= kSmallestRadius) return 0;
    const double level = std::round(std::log(radius / kSmallestRadius) / kRadiusLevelStep);
    return static_cast<std::uint8_t>(std::min(level, 255.0));
}

Mat3 branch_frame(std::span<const Vec3f> points) {
    assert(points.size() >= 2);
    const Vec3 origin = points.front().cast<double>();
    double extent = 0.0;
    for (const Vec3f& p : points) extent = std::max(extent, (p.cast<double>() - origin).norm());
    Vec3 chord = points.back().cast<double>() - origin;
    if (chord.norm() <= 1e-3 * extent) chord = points[points.size() / 2].cast<double>() - origin;
    if (chord.norm() == 0.0) return Mat3::Identity();
    const Vec3 x = chord.normalized();

    const double flat = kFlat * extent * static_cast<double>(points.size());
    Vec3 deviation = summed_deviation(points, origin, x, 0, points.size());
    // The two bends of an S cancel out: its first half decides.
    if (deviation.norm() <= flat) {
        deviation = summed_deviation(points, origin, x, 0, (points.size() + 1) / 2);
    }
    const Vec3 y = deviation.norm() > flat ? Vec3((deviation - deviation.dot(x) * x).normalized())
                                           : any_perpendicular(x);
    Vec3 z = x.cross(y);
    double moment = 0.0;
    for (const Vec3f& p : points) {
        const double height = (p.cast<double>() - origin).dot(z);
        moment += height * height * height;
    }
    if (moment < 0.0) z = -z;
    Mat3 frame;
    frame << x, y, z;
    return frame;
}

std::vector<DirectionStep> direction_code(std::span<const Vec3f> points,
                                          std::span<const float> radii) {
    assert(points.size() == radii.size() && points.size() >= 2);
    const Mat3 frame = branch_frame(points);
    std::vector<DirectionStep> steps;
    steps.reserve(points.size() - 1);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 step = frame.transpose() * (points[i] - points[i - 1]).cast<double>();
        DirectionStep code;
        code.direction = step.squaredNorm() > 0.0 ? quantize_direction(step.cast<float>())
                                                  : quantize_direction(Vec3f::UnitX());
        code.radius_level = quantize_radius(0.5 * (static_cast<double>(radii[i - 1]) + radii[i]));
        steps.push_back(code);
    }
    return steps;
}

}  // namespace ossuary::chain_code
