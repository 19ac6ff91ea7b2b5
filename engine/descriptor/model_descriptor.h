#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/matching/skeleton_descriptor.h"

namespace ossuary {

/// One global descriptor: a vector of fixed length that is compared by its own metric.
struct GlobalDescriptor {
    std::string name;  ///< e.g. d2, shape_diameter_geodesic
    std::vector<float> values;
};

/// All that the rankers compare. Scale, position and (as far as each part can) orientation are out.
struct ModelDescriptor {
    SkeletonDescriptor skeleton;  ///< for `chain-code` and `skeleton`
    std::vector<GlobalDescriptor>
        globals;                   ///< for `hybrid`, always the same names in the same order
    std::vector<float> signature;  ///< preselection: Euclidean, unit length
};

}  // namespace ossuary
