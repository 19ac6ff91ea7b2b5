#include "engine/skeleton/thinning.h"

#include <cassert>
#include <optional>
#include <string>

#include "engine/skeleton/anchors.h"
#include "engine/skeleton/parallel_thinning.h"
#include "engine/skeleton/peel.h"
#include "engine/skeleton/unit_width.h"
#include "engine/voxel/betti.h"
#include "engine/voxel/inner_runs.h"
#include "engine/voxel/morphology.h"

namespace ossuary::skeleton {
namespace {

/// Without cavities the Euler characteristic is components less tunnels.
bool has_only_components(const voxel::BitVolume& volume, std::size_t components) {
    return voxel::euler_characteristic(volume) == static_cast<std::int64_t>(components) &&
           voxel::count_cavities(volume) == 0;
}

/// The least part of the solid around the anchors, voxel by voxel, that has neither tunnels nor
/// cavities: what loops the anchors have are filled there. None where it is most of the solid.
std::optional<voxel::BitVolume> filled_around(const Anchors& anchors, const voxel::BitVolume& solid,
                                              const std::stop_token& stop) {
    const std::size_t most = solid.count() / 2;
    voxel::BitVolume around = anchors.voxels.volume();
    do {
        around = voxel::dilate(around);
        for (std::size_t w = 0; w < around.words().size(); ++w) {
            around.words()[w] &= solid.words()[w];
        }
        if (has_only_components(around, anchors.components)) return around;
    } while (around.count() < most && !stop.stop_requested());
    return std::nullopt;
}

/// A solid without tunnels and cavities shrinks onto any part of it that is one piece for each
/// component and has none either, so that the anchors are its skeleton as they stand. Where paths
/// have closed loops, what is around the anchors is peeled in its stead (a fiftieth of the time);
/// only what has tunnels or cavities to keep must be peeled as a whole.
ThinningGrid thin_anchored(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                           const ThinningOptions& options, const std::stop_token& stop) {
    Anchors anchors = find_anchors(solid, distance, options, stop);
    if (stop.stop_requested()) return std::move(anchors.voxels);
    if (has_only_components(solid, anchors.components)) {
        if (anchors.contractible) return std::move(anchors.voxels);
        if (const auto around = filled_around(anchors, solid, stop)) {
            return peel(*around, distance, anchors.voxels, stop);
        }
    }
    return peel(solid, distance, anchors.voxels, stop);
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

voxel::BitVolume thin(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                      const ThinningOptions& options, const std::stop_token& stop) {
    assert(options.method == ThinningMethod::kParallel || solid.size() == distance.size());
    if (solid.voxel_count() == 0) return solid;
    ThinningGrid skeleton = options.method == ThinningMethod::kAnchored
                                ? thin_anchored(solid, distance, options, stop)
                                : thin_in_parallel(solid, stop);
    thin_to_unit_width(skeleton, stop);
    return skeleton.volume();
}

}  // namespace ossuary::skeleton
