#pragma once

#include <stop_token>

#include "engine/matching/match_skeletons.h"

namespace ossuary::matching {

/// How differently two skeletons stand, in [0, 1], as far as their parts belong together: of the
/// nodes that match_skeletons matches, and of the middles of the limbs that end in them, the
/// straight distances among the ones against those among the others, as the sum of differences over
/// the sum. All angles between branches go into these distances, and turning or mirroring a model
/// changes none. Tips on limbs of like length, such as two arms, which tree matching cannot tell
/// apart, are matched as they stand best. 0 for equal skeletons and where nothing is matched.
/// Symmetric bit by bit.
/// The direction codes of branches (thesis sec. 3.3.2) are each in a frame of the branch's own:
/// they know how a limb is bent, not how it is held. Means nothing once asked to stop.
[[nodiscard]] double pose_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                   const SkeletonMatchOptions& options = {},
                                   const std::stop_token& stop = {});

/// The same from the correspondence of `match_skeletons(a, b)`.
[[nodiscard]] double pose_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                   const Correspondence& match, const std::stop_token& stop = {});

}  // namespace ossuary::matching
