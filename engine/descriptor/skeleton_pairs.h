#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "engine/matching/skeleton_descriptor.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kSkeletonPairsSize = 12 * 6 * 4;

/// How pairs of points of the skeleton lie to each other: the joint histogram of their distance
/// along the skeleton, of the straight distance as a share of it, and of the logarithm of the
/// smaller radius, a point weighing as the surface around it; the mean over several skeletons of
/// one model, square roots in bytes. It needs no matching, so that a spurious branch changes it
/// little. Not complete when stopped. Of the pairs of variables tried on the ten classes, first
/// tier alone: .736; with the mean radius .716, without a radius .624, without the straightness
/// .667.
std::vector<std::uint8_t> skeleton_pairs(std::span<const matching::SkeletonDescriptor> skeletons,
                                         const std::stop_token& stop = {});

/// The sum of absolute differences of the bytes, as far as `pose` goes, and of the histograms
/// without straightness (which bending changes) for the rest.
/// @pre both are of kSkeletonPairsSize bytes, pose is in [0, 1]
[[nodiscard]] double skeleton_pairs_distance(std::span<const std::uint8_t> a,
                                             std::span<const std::uint8_t> b, double pose = 1.0);

}  // namespace ossuary::descriptor
