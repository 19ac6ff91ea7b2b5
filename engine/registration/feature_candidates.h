#pragma once

#include <cstddef>
#include <vector>

#include "engine/registration/axis_candidates.h"
#include "engine/registration/local_features.h"
#include "engine/registration/similarity.h"

namespace ossuary::registration {

struct FeatureCandidateOptions {
    MotionKind kind;
    double least_scale = 0.0;  ///< with `kind.scale`: of the piece in the whole
    double most_scale = 1e300;
    std::size_t matches = 4;  ///< places in the whole that each point of the piece may go to
    std::size_t most = 6;     ///< candidates
};

struct FeatureCandidate {
    Similarity placement;  ///< of the piece in the whole
    double votes = 0.0;    ///< of the piece's points, in [0, 1]: how many go where alike ones are
};

/// Motions that bring points of a piece onto points of a whole that look alike around (by their
/// features), the most agreed on first: every two such pairs of oriented points make one, if the
/// angles in them agree, and it is counted how many pairs it brings together (the consensus of
/// Fischler and Bolles' RANSAC, 1981, over all pairs instead of random ones, so that nothing is
/// left to chance). With scale, what two points are apart says how large; the radii of their
/// features have to agree roughly. None where nothing agrees.
/// @param diagonal  of the piece's box
[[nodiscard]] std::vector<FeatureCandidate> feature_candidates(
    const LocalFeatures& piece, const LocalFeatures& whole, double diagonal,
    const FeatureCandidateOptions& options = {});

}  // namespace ossuary::registration
