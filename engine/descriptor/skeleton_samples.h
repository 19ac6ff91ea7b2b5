#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/matching/skeleton_descriptor.h"

namespace ossuary::descriptor {

/// A piece of a skeleton's branch between two neighbouring samples, at its middle; in units of the
/// descriptor's scale.
struct SkeletonSample {
    Vec3f point = Vec3f::Zero();
    double radius = 0.0;  ///< at least 1e-4
    double length = 0.0;  ///< of the piece
    std::uint32_t branch = 0;
    double along = 0.0;  ///< from the branch's node a
};

/// All pieces, branch by branch; for a skeleton that is a point, the point twice, so that it has a
/// pair; none for an empty skeleton.
[[nodiscard]] std::vector<SkeletonSample> skeleton_samples(
    const matching::SkeletonDescriptor& skeleton);

/// The mean of a histogram over several skeletons of one model, as square roots in bytes
/// (append_root_bytes); zeros without any. Not complete when stopped.
[[nodiscard]] std::vector<std::uint8_t> mean_root_bytes(
    std::span<const matching::SkeletonDescriptor> skeletons, std::size_t size, double scale,
    std::vector<float> (*histogram_of)(const matching::SkeletonDescriptor&, const std::stop_token&),
    const std::stop_token& stop);

}  // namespace ossuary::descriptor
