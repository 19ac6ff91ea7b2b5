#include "engine/descriptor/skeleton_pairs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/descriptor/byte_distance.h"
#include "engine/descriptor/histogram.h"
#include "engine/descriptor/quantize.h"
#include "engine/matching/skeleton_paths.h"

namespace ossuary {
namespace {

constexpr std::size_t kDistances = 12;
constexpr std::size_t kStraightnesses = 6;
constexpr std::size_t kRadii = 4;
static_assert(kDistances * kStraightnesses * kRadii == kSkeletonPairsSize);
constexpr double kByteScale = 510.0;
constexpr float kLeastRadius = 1e-4F;

/// A piece of the skeleton between two neighbouring samples, at its middle.
struct Sample {
    Vec3f point = Vec3f::Zero();
    double log_radius = 0.0;
    double weight = 0.0;
    std::uint32_t branch = 0;
    double along = 0.0;  ///< from the branch's node a
};

Vec3f point_of(const SkeletonDescriptor::Branch& branch, std::size_t i) {
    return {branch.points[3 * i], branch.points[3 * i + 1], branch.points[3 * i + 2]};
}

std::vector<Sample> samples_of(const SkeletonDescriptor& skeleton) {
    std::vector<Sample> samples;
    for (std::uint32_t index = 0; index < skeleton.branches.size(); ++index) {
        const SkeletonDescriptor::Branch& branch = skeleton.branches[index];
        const auto steps = static_cast<double>(branch.radii.size() - 1);
        const double step = static_cast<double>(branch.length) / steps;
        for (std::size_t i = 1; i < branch.radii.size(); ++i) {
            const float radius =
                std::max(0.5F * (branch.radii[i - 1] + branch.radii[i]), kLeastRadius);
            samples.push_back({0.5F * (point_of(branch, i - 1) + point_of(branch, i)),
                               std::log(static_cast<double>(radius)),
                               step * static_cast<double>(radius), index,
                               step * (static_cast<double>(i) - 0.5)});
        }
    }
    if (samples.empty() && !skeleton.nodes.empty()) {  // a point alone is a pair with itself
        const float radius = std::max(skeleton.nodes.front().radius, kLeastRadius);
        samples.assign(2, {Vec3f::Zero(), std::log(static_cast<double>(radius)), 1.0, 0, 0.0});
    }
    return samples;
}

/// Distances along a skeleton between any two of its samples.
class AlongSkeleton {
public:
    explicit AlongSkeleton(const SkeletonDescriptor& skeleton) : skeleton_(skeleton) {
        const SkeletonAdjacency adjacency = skeleton_adjacency(skeleton);
        for (std::uint32_t node = 0; node < skeleton.nodes.size(); ++node) {
            from_.push_back(shortest_paths(skeleton, adjacency, node).distance);
        }
    }
    /// Infinite between components.
    [[nodiscard]] double distance(const Sample& s, const Sample& t) const {
        if (skeleton_.branches.empty()) return 0.0;
        const SkeletonDescriptor::Branch& b = skeleton_.branches[s.branch];
        const SkeletonDescriptor::Branch& c = skeleton_.branches[t.branch];
        const double s_back = static_cast<double>(b.length) - s.along;
        const double t_back = static_cast<double>(c.length) - t.along;
        double best =
            std::min({s.along + from_[b.a][c.a] + t.along, s.along + from_[b.a][c.b] + t_back,
                      s_back + from_[b.b][c.a] + t.along, s_back + from_[b.b][c.b] + t_back});
        if (s.branch == t.branch) best = std::min(best, std::abs(s.along - t.along));
        return best;
    }

private:
    const SkeletonDescriptor& skeleton_;
    std::vector<std::vector<double>> from_;
};

/// The square roots of the histogram of distance and radius alone.
std::array<double, kDistances * kRadii> without_straightness(std::span<const std::uint8_t> bytes) {
    std::array<double, kDistances * kRadii> mass{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const auto root = static_cast<double>(bytes[i]);
        mass[i / (kStraightnesses * kRadii) * kRadii + i % kRadii] += root * root;
    }
    for (double& value : mass) value = std::sqrt(value);
    return mass;
}

}  // namespace

std::vector<std::uint8_t> skeleton_pairs(const SkeletonDescriptor& skeleton) {
    SoftHistogram<3> histogram({{{0.0, 2.5, static_cast<int>(kDistances)},
                                 {0.0, 1.0, static_cast<int>(kStraightnesses)},
                                 {std::log(0.01), std::log(0.4), static_cast<int>(kRadii)}}});
    const std::vector<Sample> samples = samples_of(skeleton);
    const AlongSkeleton along(skeleton);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (std::size_t j = i + 1; j < samples.size(); ++j) {
            const Sample& s = samples[i];
            const Sample& t = samples[j];
            const double straight = static_cast<double>((s.point - t.point).norm());
            double distance = along.distance(s, t);
            if (!std::isfinite(distance)) distance = straight;
            const double share = distance > 0.0 ? straight / distance : 1.0;
            histogram.add({distance, share, std::min(s.log_radius, t.log_radius)},
                          s.weight * t.weight);
        }
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(kSkeletonPairsSize);
    append_root_bytes(histogram.normalized(), kByteScale, bytes);
    return bytes;
}

double skeleton_pairs_distance(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                               double pose) {
    assert(a.size() == kSkeletonPairsSize && b.size() == kSkeletonPairsSize);
    const double whole = byte_distance(a.data(), b.data(), kSkeletonPairsSize);
    if (pose >= 1.0) return whole;
    const auto build_a = without_straightness(a), build_b = without_straightness(b);
    double build = 0.0;
    for (std::size_t i = 0; i < build_a.size(); ++i) build += std::abs(build_a[i] - build_b[i]);
    // The same mass in fewer bins has smaller roots.
    build *= std::sqrt(static_cast<double>(kStraightnesses));
    return pose * whole + (1.0 - pose) * build;
}

}  // namespace ossuary
