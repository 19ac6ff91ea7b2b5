#include "engine/ranking/fusion.h"

#include <algorithm>
#include <cmath>

namespace ossuary {
namespace {

/// Flat near the optimum on the ten classes: halving or doubling any one changes the first tier by
/// less than one point.
constexpr ComponentValues kWeights = {3.0, 1.0, 1.0, 0.75, 0.75, 1.0};
/// Below this share of the mean distance a pair counts as nearly equal.
constexpr double kFade = 0.02;
/// No single component may say more than this many deviations.
constexpr double kMaxDeviations = 8.0;

ComponentValues weights_of(const FusionSide& a, const FusionSide& b) {
    ComponentValues weights = kWeights;
    weights[0] *= 0.5 * (a.information + b.information);
    double total = 0.0;
    for (const double weight : weights) total += weight;
    for (double& weight : weights) weight /= total;
    return weights;
}

/// Each component's weight times its distance over the mean.
ComponentValues ratios(const ComponentValues& distances, const FusionSide& a, const FusionSide& b,
                       const ComponentValues& weights) {
    ComponentValues result{};
    for (std::size_t c = 0; c < kComponentCount; ++c) {
        const double ratio = distances[c] * (0.5 / a.scale.mean[c] + 0.5 / b.scale.mean[c]);
        result[c] = weights[c] * std::min(ratio, 1.0 + kMaxDeviations);
    }
    return result;
}

double sum_of(const ComponentValues& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

}  // namespace

double skeleton_information(const SkeletonDescriptor& skeleton) {
    double length = 0.0;
    for (const SkeletonDescriptor::Branch& branch : skeleton.branches) {
        length += static_cast<double>(branch.length);
    }
    // A single limb as long as the square root of the area is a rod; a ball has no length at all.
    const double by_length = std::min(length / 1.0, 1.0);
    const double branches = static_cast<double>(skeleton.branches.size());
    const double by_branches = std::min(branches / 5.0, 1.0);
    return std::sqrt(by_length * by_branches);
}

FusionSide fusion_side(const ModelDescriptor& model, const ModelScale& scale) {
    return {scale, skeleton_information(model.skeleton)};
}

double fused_distance(const ComponentValues& distances, const FusionSide& a, const FusionSide& b) {
    const ComponentValues weights = weights_of(a, b);
    double deviations = 0.0;
    for (std::size_t c = 0; c < kComponentCount; ++c) {
        const double from_a = (distances[c] - a.scale.mean[c]) / a.scale.deviation[c];
        const double from_b = (distances[c] - b.scale.mean[c]) / b.scale.deviation[c];
        deviations += weights[c] * std::min(0.5 * (from_a + from_b), kMaxDeviations);
    }
    const double nearness = sum_of(ratios(distances, a, b, weights)) / kFade;
    return std::exp(deviations) * -std::expm1(-nearness);
}

ComponentValues fused_parts(const ComponentValues& distances, const FusionSide& a,
                            const FusionSide& b) {
    ComponentValues parts = ratios(distances, a, b, weights_of(a, b));
    const double sum = sum_of(parts);
    if (sum <= 0.0) return {};
    const double scale = fused_distance(distances, a, b) / sum;
    for (double& part : parts) part *= scale;
    return parts;
}

}  // namespace ossuary
