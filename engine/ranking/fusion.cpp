#include "engine/ranking/fusion.h"

#include <algorithm>
#include <cmath>

namespace ossuary {
namespace {

/// Tuned on the ten-class set by first tier.
constexpr ComponentValues kWeights = {2.0, 1.0, 1.0, 0.5, 0.5, 0.5};

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

ComponentValues fused_parts(const ComponentValues& distances, const FusionSide& a,
                            const FusionSide& b) {
    ComponentValues weights = kWeights;
    weights[0] *= 0.5 * (a.information + b.information);
    double total = 0.0;
    for (const double weight : weights) total += weight;
    ComponentValues parts{};
    for (std::size_t c = 0; c < kComponentCount; ++c) {
        const double normalized = distances[c] * (0.5 / a.scale[c] + 0.5 / b.scale[c]);
        parts[c] = weights[c] / total * normalized;
    }
    return parts;
}

double fused_distance(const ComponentValues& distances, const FusionSide& a, const FusionSide& b) {
    double sum = 0.0;
    for (const double part : fused_parts(distances, a, b)) sum += part;
    return sum;
}

}  // namespace ossuary
