#pragma once

#include <vector>

#include "engine/registration/similarity.h"
#include "engine/registration/surface_points.h"

namespace ossuary::registration {

/// What a motion may do beside turning and moving.
struct MotionKind {
    bool mirror = false;
    bool scale = false;  ///< as the root mean square distances from the centres say
};

/// Motions that bring the centre and the principal axes of one surface onto those of another: four
/// signs each; where moments are alike (within a tenth) the axes may also change places, and where
/// two are they turn about the third in steps of 15 degrees.
/// @pre both have points
[[nodiscard]] std::vector<Similarity> axis_candidates(const SurfacePoints& from,
                                                      const SurfacePoints& to,
                                                      const MotionKind& kind = {});

}  // namespace ossuary::registration
