#include "engine/skeleton/skeletonize.h"

#include "engine/mesh/canonical_pose.h"
#include "engine/skeleton/extract_graph.h"

namespace ossuary::skeleton {
namespace {

Error cancelled(const char* before) {
    return {ErrorCode::kCancelled, std::string("skeletonize: stopped before ") + before};
}

/// The model's vertices in voxels of the grid: the surface of eq. 3.3.
std::vector<Vec3> surface_points(const mesh::TriangleMesh& mesh,
                                 const WorldFromGrid& world_from_grid) {
    std::vector<Vec3> points;
    points.reserve(mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices) points.push_back(world_from_grid.grid(vertex));
    return points;
}

}  // namespace

Result<Skeleton> skeletonize(const mesh::TriangleMesh& mesh, const SkeletonizeOptions& options,
                             std::stop_token stop) {
    Skeleton skeleton;
    Stopwatch watch;
    const auto finished = [&](const char* stage) {
        skeleton.stage_times.push_back({stage, watch.lap_ms()});
    };
    if (stop.stop_requested()) return cancelled("voxelize");
    voxel::VoxelizeOptions voxelize_options = options.voxelize;
    if (options.canonical_pose) voxelize_options.rotation = mesh::canonical_pose(mesh);
    Result<voxel::VoxelSolid> solid = voxel::voxelize(mesh, voxelize_options, stop);
    if (!solid) return solid.error();
    skeleton.solid = *std::move(solid);
    finished("voxelize");

    if (stop.stop_requested()) return cancelled("distance_transform");
    skeleton.distance = voxel::distance_transform(skeleton.solid.volume, stop);
    finished("distance_transform");

    if (stop.stop_requested()) return cancelled("thin");
    skeleton.thinned_volume =
        thin(skeleton.solid.volume, skeleton.distance, options.thinning, stop);
    finished("thin");

    if (stop.stop_requested()) return cancelled("refine");
    skeleton.thinned = extract_graph(skeleton.thinned_volume, skeleton.distance, stop);
    if (stop.stop_requested()) return cancelled("refine");
    const std::vector<Vec3> surface = surface_points(mesh, skeleton.solid.world_from_grid);
    RefinedSkeleton refined = refine(skeleton.thinned, surface, options.refine, stop);
    if (stop.stop_requested()) return cancelled("the end");
    skeleton.pruned = std::move(refined.pruned);
    skeleton.refined = std::move(refined.refined);
    finished("refine");
    return skeleton;
}

}  // namespace ossuary::skeleton
