#pragma once

#include "engine/ranking/normalization.h"

namespace ossuary {

/// How telling a skeleton is, in [0, 1]: near 0 for a point or a short stub, where the body is
/// thick beside its skeleton, rising with the number of branches and their length. It scales the
/// skeleton's weight in the fusion (thesis sec. 5.2 names the shapes without a telling skeleton).
[[nodiscard]] double skeleton_information(const SkeletonDescriptor& skeleton);

/// What the fusion needs of one model beside its distances.
struct FusionSide {
    ModelScale scale;
    double information = 1.0;
};

[[nodiscard]] FusionSide fusion_side(const ModelDescriptor& model, const ModelScale& scale);

/// The share of each component in the fused distance of two models; their sum is the distance.
/// Each component is divided by both models' scales (averaged, so that it stays symmetric) and
/// weighted; weights sum to one. Zero for equal models, 1 for a pair as unlike as any.
[[nodiscard]] ComponentValues fused_parts(const ComponentValues& distances, const FusionSide& a,
                                          const FusionSide& b);
[[nodiscard]] double fused_distance(const ComponentValues& distances, const FusionSide& a,
                                    const FusionSide& b);

}  // namespace ossuary
