#include "engine/descriptor/skeleton_layout.h"

#include <algorithm>
#include <cmath>

#include "engine/descriptor/histogram.h"
#include "engine/descriptor/quantize.h"
#include "engine/descriptor/skeleton_samples.h"

namespace ossuary::descriptor {
namespace {

constexpr int kLayoutDistances = 7;
constexpr int kCosines = 7;
static_assert(kLayoutDistances * kLayoutDistances * kCosines == kSkeletonLayoutSize);
constexpr double kFarthest = 1.6;

/// The mean square distance of a ball's points from its middle, over its squared radius.
constexpr double kBallSpread = 0.6;

double sample_mass(const SkeletonSample& sample) {
    return sample.length * sample.radius * sample.radius;
}

std::vector<float> layout_histogram(const matching::SkeletonDescriptor& skeleton,
                                    const std::stop_token& stop) {
    const std::vector<SkeletonSample> samples = skeleton_samples(skeleton);
    Vec3 centre = Vec3::Zero();
    double total = 0.0;
    for (const SkeletonSample& sample : samples) {
        centre += sample_mass(sample) * sample.point.cast<double>();
        total += sample_mass(sample);
    }
    if (total > 0.0) centre /= total;
    std::vector<Vec3> points;
    std::vector<double> distances;
    for (const SkeletonSample& sample : samples) {
        points.emplace_back(sample.point.cast<double>() - centre);
        distances.push_back(
            std::sqrt(points.back().squaredNorm() + kBallSpread * sample.radius * sample.radius));
    }
    SoftHistogram<3> histogram({{{0.0, kFarthest, kLayoutDistances},
                                 {0.0, kFarthest, kLayoutDistances},
                                 {-1.0, 1.0, kCosines}}});
    for (std::size_t i = 0; i < points.size() && !stop.stop_requested(); ++i) {
        for (std::size_t j = i; j < points.size(); ++j) {
            constexpr double kLeast = 1e-9;
            const double cosine =
                points[i].dot(points[j]) / std::max(kLeast, distances[i] * distances[j]);
            const double weight =
                (i == j ? 0.5 : 1.0) * sample_mass(samples[i]) * sample_mass(samples[j]);
            histogram.add({std::min(distances[i], distances[j]),
                           std::max(distances[i], distances[j]), cosine},
                          weight);
        }
    }
    return histogram.normalized();
}

}  // namespace

std::vector<std::uint8_t> skeleton_layout(std::span<const matching::SkeletonDescriptor> skeletons,
                                          const std::stop_token& stop) {
    return mean_root_bytes(skeletons, kSkeletonLayoutSize, kHistogramByteScale, layout_histogram,
                           stop);
}

}  // namespace ossuary::descriptor
