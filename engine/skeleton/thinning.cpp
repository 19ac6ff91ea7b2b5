#include "engine/skeleton/thinning.h"

#include <cassert>
#include <string>

#include "engine/skeleton/anchors.h"
#include "engine/skeleton/parallel_thinning.h"
#include "engine/skeleton/peel.h"
#include "engine/skeleton/unit_width.h"
#include "engine/voxel/betti.h"
#include "engine/voxel/inner_runs.h"

namespace ossuary {
namespace {

ThinningGrid thin_anchored(const BitVolume& solid, const DistanceField& distance,
                           const ThinningOptions& options) {
    Anchors anchors = find_anchors(solid, distance, options);
    // A solid without tunnels and cavities shrinks onto the anchors whatever the order, so that
    // they are its skeleton as they stand; only what has more to keep must be peeled.
    // Without cavities the Euler characteristic is components less tunnels.
    const bool only_components =
        anchors.contractible &&
        euler_characteristic(solid) == static_cast<std::int64_t>(anchors.components) &&
        count_cavities(solid) == 0;
    if (only_components) return std::move(anchors.voxels);
    return peel(solid, distance, anchors.voxels);
}

}  // namespace

std::string_view to_string(ThinningMethod method) {
    return method == ThinningMethod::kAnchored ? "anchored" : "parallel";
}

Result<ThinningMethod> parse_thinning_method(std::string_view name) {
    if (name == "anchored") return ThinningMethod::kAnchored;
    if (name == "parallel") return ThinningMethod::kParallel;
    return {ErrorCode::kInvalidArgument, "thinning method: found '" + std::string(name) +
                                             "', expected 'anchored' or 'parallel'"};
}

BitVolume thin(const BitVolume& solid, const DistanceField& distance,
               const ThinningOptions& options) {
    assert(options.method == ThinningMethod::kParallel || solid.size() == distance.size());
    if (solid.voxel_count() == 0) return solid;
    ThinningGrid skeleton = options.method == ThinningMethod::kAnchored
                                ? thin_anchored(solid, distance, options)
                                : thin_in_parallel(solid);
    thin_to_unit_width(skeleton);
    return skeleton.volume();
}

}  // namespace ossuary
