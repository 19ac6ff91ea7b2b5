#include "engine/ranking/pair_distances.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "engine/matching/pose_distance.h"

namespace ossuary::ranking {

std::string_view component_name(std::size_t component) {
    assert(component < kComponentCount);
    return component == 0 ? "skeleton" : descriptor::kGlobalDescriptorKinds[component - 1].name;
}

double PairMeter::pose_weight() const {
    constexpr double kNone = kDefaultPose;
    constexpr double kFull = 2.0;
    return kFull * std::max(0.0, skeleton_options_.pose - kNone) / (1.0 - kNone);
}

double PairMeter::skeleton(const descriptor::ModelDescriptor& a,
                           const descriptor::ModelDescriptor& b) {
    const double weight = pose_weight();
    if (weight <= 0.0) {
        return matching::skeleton_distance(a.skeleton, b.skeleton, skeleton_options_,
                                           skeleton_workspace_);
    }
    const matching::Match match =
        matching::match_skeletons(a.skeleton, b.skeleton, skeleton_options_, stop_);
    return match.distance +
           weight * matching::pose_distance(a.skeleton, b.skeleton, match.correspondence, stop_);
}

ComponentValues PairMeter::components(const descriptor::ModelDescriptor& a,
                                      const descriptor::ModelDescriptor& b) {
    ComponentValues values = global_components(a, b);
    values[0] = skeleton(a, b);
    return values;
}

ComponentValues PairMeter::global_components(const descriptor::ModelDescriptor& a,
                                             const descriptor::ModelDescriptor& b) const {
    ComponentValues values{};
    for (std::size_t c = 1; c < components_; ++c) {
        const bool both = a.globals.size() >= c && b.globals.size() >= c;
        values[c] = both ? descriptor::global_distance(a.globals[c - 1], b.globals[c - 1],
                                                       descriptor::kGlobalDescriptorKinds[c - 1],
                                                       pose_share_)
                         : std::numeric_limits<double>::infinity();
    }
    return values;
}

}  // namespace ossuary::ranking
