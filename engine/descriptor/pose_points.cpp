#include "engine/descriptor/pose_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ossuary::descriptor {
namespace {

/// Of moving points to the middles of their patches (Lloyd, "Least squares quantization in PCM",
/// 1982), which makes the choice of the first ones matter less.
constexpr int kMiddleRounds = 4;

std::vector<Vec3> farthest_points(const ShellGraph& graph, const Vec3& centre) {
    std::vector<float> distance(graph.size(), std::numeric_limits<float>::infinity());
    std::vector<Vec3> picked;
    Vec3f last = centre.cast<float>();
    while (picked.size() < std::min(kPosePoints, graph.size())) {
        std::size_t next = 0;
        for (std::size_t i = 0; i < graph.size(); ++i) {
            distance[i] = std::min(distance[i], (graph.points[i] - last).squaredNorm());
            if (distance[i] > distance[next]) next = i;
        }
        if (picked.empty()) std::fill(distance.begin(), distance.end(), distance[next]);
        last = graph.points[next];
        picked.emplace_back(last.cast<double>());
    }
    return picked;
}

/// The middle of what of the surface is nearest to each of the points.
std::vector<Vec3> patch_middles(const ShellGraph& graph, const std::vector<Vec3>& points) {
    std::vector<Vec3> sum(points.size(), Vec3::Zero());
    std::vector<double> area(points.size(), 0.0);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const Vec3 place = graph.points[i].cast<double>();
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double distance = (place - points[k]).squaredNorm();
            if (distance < least) least = distance, nearest = k;
        }
        const auto weight = static_cast<double>(graph.areas[i]);
        sum[nearest] += weight * place;
        area[nearest] += weight;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        sum[k] = area[k] > 0.0 ? Vec3(sum[k] / area[k]) : points[k];
    }
    return sum;
}

Vec3 centre_of(const ShellGraph& graph) {
    Vec3 centre = Vec3::Zero();
    for (std::size_t i = 0; i < graph.size(); ++i) {
        centre += static_cast<double>(graph.areas[i]) * graph.points[i].cast<double>();
    }
    return graph.total_area > 0.0 ? Vec3(centre / graph.total_area) : centre;
}

}  // namespace

std::vector<std::uint8_t> pose_points(const ShellGraph& graph, double scale, const Mat3& rotation) {
    std::vector<std::uint8_t> bytes(kPosePointsSize, 0);
    if (graph.empty()) return bytes;
    const Vec3 centre = centre_of(graph);
    std::vector<Vec3> middles = farthest_points(graph, centre);
    for (int round = 0; round < kMiddleRounds; ++round) middles = patch_middles(graph, middles);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& point : middles) mean += point;
    mean /= static_cast<double>(middles.size());
    double square = 0.0;
    for (const Vec3& point : middles) square += (point - mean).squaredNorm();
    const double spread = std::sqrt(square / static_cast<double>(middles.size()));
    const double size = std::sqrt(spread * scale);
    for (std::size_t i = 0; i < kPosePoints; ++i) {
        const Vec3 offset = rotation * (middles[i % middles.size()] - mean);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double units =
                size > 0.0 ? offset[static_cast<Eigen::Index>(axis)] / (size * kPosePointsUnit)
                           : 0.0;
            const auto number =
                static_cast<std::int16_t>(std::lround(std::clamp(units, -32767.0, 32767.0)));
            const auto bits = static_cast<std::uint16_t>(number);
            bytes[6 * i + 2 * axis] = static_cast<std::uint8_t>(bits & 0xFFU);
            bytes[6 * i + 2 * axis + 1] = static_cast<std::uint8_t>(bits >> 8);
        }
    }
    return bytes;
}

}  // namespace ossuary::descriptor
