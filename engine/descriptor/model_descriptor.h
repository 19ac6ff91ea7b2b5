#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/matching/skeleton_descriptor.h"

namespace ossuary::descriptor {

/// One global descriptor: bytes of a fixed number that are compared by a metric of their own
/// (global_distance).
struct GlobalDescriptor {
    std::string name;  ///< e.g. views
    std::vector<std::uint8_t> values;
};

/// All that the rankers compare. Scale, position and (as far as each part can) orientation are out.
struct ModelDescriptor {
    matching::SkeletonDescriptor skeleton;  ///< for `chain-code` and `skeleton`
    std::vector<GlobalDescriptor>
        globals;                   ///< for `hybrid`, always the same names in the same order
    std::vector<float> signature;  ///< preselection: Euclidean, unit length
};

}  // namespace ossuary::descriptor
