#include "engine/ranking/pair_distances.h"

#include <algorithm>
#include <limits>

namespace ossuary::ranking {
namespace {

/// The distance by one global descriptor; infinite where a model has none.
double distance_by(const descriptor::ModelDescriptor& a, const descriptor::ModelDescriptor& b,
                   std::size_t place, double pose = 1.0) {
    if (a.globals.size() <= place || b.globals.size() <= place) {
        return std::numeric_limits<double>::infinity();
    }
    return descriptor::global_distance(a.globals[place], b.globals[place],
                                       descriptor::kGlobalDescriptorKinds[place], pose);
}

}  // namespace

double build_of(double thickness, double thickness_pairs, double skeleton_pairs) {
    // Each over its mean over many kinds.
    constexpr double kThickness = 3.0 / 1900.0;
    constexpr double kThicknessPairs = 1.0 / 4000.0;
    constexpr double kSkeletonPairs = 1.2 / 3000.0;
    return kThickness * thickness + kThicknessPairs * thickness_pairs +
           kSkeletonPairs * skeleton_pairs;
}

double build_distance(const descriptor::ModelDescriptor& a, const descriptor::ModelDescriptor& b) {
    constexpr double kBuildAlone = 0.0;
    return build_of(distance_by(a, b, descriptor::kThicknessPlace),
                    distance_by(a, b, descriptor::kThicknessPairsPlace),
                    distance_by(a, b, descriptor::kSkeletonPairsPlace, kBuildAlone));
}

double pose_distance(const descriptor::ModelDescriptor& a, const descriptor::ModelDescriptor& b) {
    return distance_by(a, b, descriptor::kPosePointsPlace);
}

ComponentValues PairMeter::components(const descriptor::ModelDescriptor& a,
                                      const descriptor::ModelDescriptor& b) {
    ComponentValues values = cheap_components(a, b);
    if (stop_.stop_requested()) return values;
    if (pose_ > 0.0 && pose_ < 1.0) {
        values[0] = matching::skeleton_distance(a.skeleton, b.skeleton, skeleton_options_,
                                                skeleton_workspace_);
    }
    if (pose_ > kDefaultPose) values[kPoseComponent] = pose_distance(a, b);
    return values;
}

ComponentValues PairMeter::cheap_components(const descriptor::ModelDescriptor& a,
                                            const descriptor::ModelDescriptor& b) const {
    ComponentValues values{};
    for (std::size_t c = 1; c < kBuildComponent; ++c) {
        if (pose_ > 0.0 && pose_ < 1.0 && fuses(ranker_, c)) values[c] = distance_by(a, b, c - 1);
    }
    values[kBuildComponent] = build_distance(a, b);
    if (size_ > 0.0) values[kSizeComponent] = distance_by(a, b, descriptor::kBodySizePlace);
    return values;
}

}  // namespace ossuary::ranking
