#include "engine/skeleton/skeletonize.h"

#include "engine/mesh/canonical_pose.h"
#include "engine/skeleton/extract_graph.h"
#include "engine/skeleton/surface_points.h"

namespace ossuary::skeleton {
namespace {

Error cancelled(const char* before) {
    return {ErrorCode::kCancelled, std::string("skeletonize: stopped before ") + before};
}

bool needs_surface(const RefineOptions& options) {
    return options.significance || options.pruning == PruningMethod::kSignificance;
}

}  // namespace

mesh::Body find_body(const mesh::TriangleMesh& mesh, const SkeletonizeOptions& options,
                     const std::stop_token& stop) {
    std::optional<Mat3> axes;
    if (!options.canonical_pose) axes = options.voxelize.rotation;
    if (!options.voxelize.whole_mesh) {
        return mesh::find_body(mesh, voxel::body_options(options.voxelize, axes), stop);
    }
    mesh::Body body;
    body.axes = axes ? *axes : mesh::canonical_pose(mesh);
    return body;
}

Result<Skeleton> skeletonize(const mesh::TriangleMesh& whole, const SkeletonizeOptions& options,
                             std::stop_token stop) {
    if (stop.stop_requested()) return cancelled("voxelize");
    Stopwatch watch;
    mesh::Body body = find_body(whole, options, stop);
    const double body_ms = watch.lap_ms();
    auto made = skeletonize(whole, std::move(body), options, std::move(stop));
    if (made) made->stage_times.front().milliseconds += body_ms;
    return made;
}

Result<Skeleton> skeletonize(const mesh::TriangleMesh& whole, mesh::Body body,
                             const SkeletonizeOptions& options, std::stop_token stop) {
    Skeleton skeleton;
    Stopwatch watch;
    const auto begin = [&](const char* stage) {
        if (options.on_stage) options.on_stage(stage);
    };
    const auto finished = [&](const char* stage) {
        skeleton.stage_times.push_back({stage, watch.lap_ms()});
    };
    if (stop.stop_requested()) return cancelled("voxelize");
    begin("voxelize");
    skeleton.body = std::move(body);
    const mesh::TriangleMesh& mesh = skeleton.body.of(whole);
    voxel::VoxelizeOptions voxelize_options = options.voxelize;
    voxelize_options.rotation = skeleton.body.axes;
    voxelize_options.whole_mesh = true;
    if (stop.stop_requested()) return cancelled("voxelize");
    Result<voxel::VoxelSolid> solid = voxel::voxelize(mesh, voxelize_options, stop);
    if (!solid) return solid.error();
    skeleton.solid = *std::move(solid);
    voxel::warn_of_pieces_apart(skeleton.body, skeleton.solid.warnings);
    finished("voxelize");

    if (stop.stop_requested()) return cancelled("distance_transform");
    begin("distance_transform");
    skeleton.distance = voxel::distance_transform(skeleton.solid.volume, stop);
    finished("distance_transform");

    if (stop.stop_requested()) return cancelled("thin");
    begin("thin");
    skeleton.thinned_volume =
        thin(skeleton.solid.volume, skeleton.distance, options.thinning, stop);
    finished("thin");

    if (stop.stop_requested()) return cancelled("refine");
    begin("refine");
    skeleton.thinned = extract_graph(skeleton.thinned_volume, skeleton.distance, stop);
    if (stop.stop_requested()) return cancelled("refine");
    std::vector<Vec3> surface;
    if (needs_surface(options.refine)) {
        surface = surface_points(mesh, skeleton.solid.world_from_grid);
    }
    RefinedSkeleton refined = refine(skeleton.thinned, surface, options.refine, stop);
    if (stop.stop_requested()) return cancelled("the end");
    skeleton.pruned = std::move(refined.pruned);
    skeleton.refined = std::move(refined.refined);
    finished("refine");
    return skeleton;
}

}  // namespace ossuary::skeleton
