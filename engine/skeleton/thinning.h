#pragma once

#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/voxel/bit_volume.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary::skeleton {

enum class ThinningMethod {
    kAnchored,  ///< tips found by distance-weighted geodesics, simple points removed inwards
    kParallel,  ///< the thesis' fully parallel thinning, sec. 3.2.1, then spatial-median unit width
};

[[nodiscard]] std::string_view to_string(ThinningMethod method);
Result<ThinningMethod> parse_thinning_method(std::string_view name);

struct ThinningOptions {
    ThinningMethod method = ThinningMethod::kAnchored;
    int max_tips = 40;              ///< anchored: at most this many tips
    double coverage_share = 0.026;  ///< anchored: stop when every voxel is covered up to this share
                                    ///< of the longest side, 2.5 voxels at resolution 96
    double coverage_voxels = 2.5;   ///< anchored: or up to this, whichever is more
    double radius_factor = 1.8;     ///< anchored: how much of a tip's radius counts as covered
};

/// The curve skeleton of `solid` as voxels: a subset of it with the same components, tunnels and
/// cavities (always), one voxel wide.
/// When stopped, what there is by then.
/// @param distance  of `solid`; kParallel does not look at it, and any will do
voxel::BitVolume thin(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                      const ThinningOptions& options = {}, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
