#include "engine/descriptor/skeleton_pairs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/descriptor/byte_distance.h"
#include "engine/descriptor/histogram.h"
#include "engine/descriptor/quantize.h"
#include "engine/descriptor/skeleton_samples.h"
#include "engine/matching/skeleton_paths.h"

namespace ossuary::descriptor {
namespace {

constexpr std::size_t kPairDistances = 12;
constexpr std::size_t kStraightnesses = 6;
constexpr std::size_t kRadii = 4;
static_assert(kPairDistances * kStraightnesses * kRadii == kSkeletonPairsSize);

/// Distances along a skeleton between any two of its samples.
class AlongSkeleton {
public:
    explicit AlongSkeleton(const matching::SkeletonDescriptor& skeleton) : skeleton_(skeleton) {
        const matching::SkeletonAdjacency adjacency = matching::skeleton_adjacency(skeleton);
        for (std::uint32_t node = 0; node < skeleton.nodes.size(); ++node) {
            from_.push_back(matching::shortest_paths(skeleton, adjacency, node).distance);
        }
    }
    /// Infinite between components.
    [[nodiscard]] double distance(const SkeletonSample& s, const SkeletonSample& t) const {
        if (skeleton_.branches.empty()) return 0.0;
        const matching::SkeletonDescriptor::Branch& b = skeleton_.branches[s.branch];
        const matching::SkeletonDescriptor::Branch& c = skeleton_.branches[t.branch];
        const double s_back = static_cast<double>(b.length) - s.along;
        const double t_back = static_cast<double>(c.length) - t.along;
        double best =
            std::min({s.along + from_[b.a][c.a] + t.along, s.along + from_[b.a][c.b] + t_back,
                      s_back + from_[b.b][c.a] + t.along, s_back + from_[b.b][c.b] + t_back});
        if (s.branch == t.branch) best = std::min(best, std::abs(s.along - t.along));
        return best;
    }

private:
    const matching::SkeletonDescriptor& skeleton_;
    std::vector<std::vector<double>> from_;
};

std::vector<float> pairs_histogram(const matching::SkeletonDescriptor& skeleton,
                                   const std::stop_token& stop) {
    SoftHistogram<3> histogram({{{0.0, 2.5, static_cast<int>(kPairDistances)},
                                 {0.0, 1.0, static_cast<int>(kStraightnesses)},
                                 {std::log(0.01), std::log(0.4), static_cast<int>(kRadii)}}});
    const std::vector<SkeletonSample> samples = skeleton_samples(skeleton);
    const AlongSkeleton along(skeleton);
    std::vector<double> logarithms;  // of the radii: one for each sample, not for each pair
    for (const SkeletonSample& sample : samples) logarithms.push_back(std::log(sample.radius));
    for (std::size_t i = 0; i < samples.size() && !stop.stop_requested(); ++i) {
        for (std::size_t j = i + 1; j < samples.size(); ++j) {
            const SkeletonSample& s = samples[i];
            const SkeletonSample& t = samples[j];
            const auto straight = static_cast<double>((s.point - t.point).norm());
            double distance = along.distance(s, t);
            if (!std::isfinite(distance)) distance = straight;
            const double share = distance > 0.0 ? straight / distance : 1.0;
            histogram.add({distance, share, std::min(logarithms[i], logarithms[j])},
                          s.length * s.radius * t.length * t.radius);
        }
    }
    return histogram.normalized();
}

/// The square roots of the histogram of distance and radius alone.
std::array<double, kPairDistances * kRadii> without_straightness(
    std::span<const std::uint8_t> bytes) {
    std::array<double, kPairDistances * kRadii> mass{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const auto root = static_cast<double>(bytes[i]);
        mass[i / (kStraightnesses * kRadii) * kRadii + i % kRadii] += root * root;
    }
    for (double& value : mass) value = std::sqrt(value);
    return mass;
}

}  // namespace

std::vector<std::uint8_t> skeleton_pairs(std::span<const matching::SkeletonDescriptor> skeletons,
                                         const std::stop_token& stop) {
    return mean_root_bytes(skeletons, kSkeletonPairsSize, kHistogramByteScale, pairs_histogram,
                           stop);
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

}  // namespace ossuary::descriptor
