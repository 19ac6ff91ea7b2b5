#pragma once

#include <vector>

#include "engine/descriptor/model_descriptor.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kSignatureSize = 256;

/// The preselection signature: a soft 8 x 8 histogram of skeleton length over (geodesic distance to
/// the root, log radius) and coarse copies of the views, of the surface's pairs and of thickness
/// and local volume, 64 values each; every part square-rooted where it is a histogram and of the
/// same weight, the whole of unit length, so that the Euclidean distance of two lies in [0, 2].
/// @pre the skeleton's matching data is derived, the globals are those of global_descriptors
std::vector<float> preselection_signature(const matching::SkeletonDescriptor& skeleton,
                                          const std::vector<GlobalDescriptor>& globals);

}  // namespace ossuary::descriptor
