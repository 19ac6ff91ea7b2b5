#include "engine/ranking/pair_distances.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace ossuary {

std::string_view component_name(std::size_t component) {
    assert(component < kComponentCount);
    return component == 0 ? "skeleton" : kGlobalDescriptorKinds[component - 1].name;
}

ComponentValues PairMeter::components(const ModelDescriptor& a, const ModelDescriptor& b) {
    ComponentValues values = global_components(a, b);
    values[0] = skeleton(a, b);
    return values;
}

ComponentValues PairMeter::global_components(const ModelDescriptor& a,
                                             const ModelDescriptor& b) const {
    ComponentValues values{};
    const double pose = std::min(skeleton_options_.pose / RankOptions{}.pose, 1.0);
    for (std::size_t c = 1; c < components_; ++c) {
        const bool both = a.globals.size() >= c && b.globals.size() >= c;
        values[c] = both ? global_distance(a.globals[c - 1], b.globals[c - 1],
                                           kGlobalDescriptorKinds[c - 1], pose)
                         : std::numeric_limits<double>::infinity();
    }
    return values;
}

}  // namespace ossuary
