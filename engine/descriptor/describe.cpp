#include "engine/descriptor/describe.h"

#include <utility>

#include "engine/descriptor/body_scale.h"
#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/signature.h"
#include "engine/descriptor/solid_surface.h"

namespace ossuary {

Result<Description> describe(const TriangleMesh& mesh, const DescribeOptions& options,
                             std::stop_token stop) {
    Result<Skeleton> made = skeletonize(mesh, options.skeletonize, stop);
    if (!made) return made.error();
    const Skeleton& skeleton = *made;
    const auto cancelled = [&] { return Error{ErrorCode::kCancelled, "describing was cancelled"}; };

    Description description;
    description.warnings = skeleton.solid.warnings;
    description.stage_times = skeleton.stage_times;
    Stopwatch watch;
    const auto lap = [&](const char* stage) {
        description.stage_times.push_back({stage, watch.lap_ms()});
    };

    const SolidSurface surface = solid_surface(skeleton.solid.volume);
    lap("surface");
    if (stop.stop_requested()) return cancelled();

    // The solid's own boundary, not the mesh's triangles: soups have walls inside and twice.
    const double scale =
        body_scale(surface.total_area, static_cast<double>(skeleton.solid.volume.count()));
    description.descriptor.skeleton = describe_skeleton(skeleton.refined, scale);
    description.descriptor.skeleton.solid_volume = static_cast<float>(
        static_cast<double>(skeleton.solid.volume.count()) / (scale * scale * scale));
    lap("describe_skeleton");
    if (stop.stop_requested()) return cancelled();

    description.descriptor.globals =
        global_descriptors(surface, skeleton.solid.volume, description.descriptor.skeleton);
    lap("global_descriptors");
    if (stop.stop_requested()) return cancelled();

    description.descriptor.signature =
        preselection_signature(description.descriptor.skeleton, description.descriptor.globals);
    description.skeleton = to_world(skeleton.refined, skeleton.solid.world_from_grid);
    lap("signature");
    return description;
}

}  // namespace ossuary
