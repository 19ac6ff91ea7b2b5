#include "engine/descriptor/describe.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/descriptor/body_scale.h"
#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/signature.h"
#include "engine/descriptor/solid_surface.h"
#include "engine/skeleton/tube_radii.h"

namespace ossuary::descriptor {
namespace {

/// How the further grids are turned against the first one; any turn far from the identity and from
/// each other will do.
std::array<Mat3, kMaxTurnedGrids> grid_turns() {
    const auto turn = [](double angle, const Vec3& axis) {
        return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    };
    return {turn(0.7, Vec3(1.0, 1.0, 1.0)),  turn(1.1, Vec3(1.0, -2.0, 0.5)),
            turn(0.9, Vec3(-1.0, 0.3, 1.0)), turn(0.5, Vec3(1.0, 0.1, -0.2)),
            turn(0.8, Vec3(0.2, 1.0, -0.7)), turn(1.0, Vec3(1.0, 0.2, 1.1))};
}

skeleton::SkeletonGraph with_tube_radii(const skeleton::SkeletonGraph& graph,
                                        const voxel::BitVolume& solid) {
    skeleton::SkeletonGraph result = graph;
    std::vector<std::vector<double>> radii = skeleton::tube_radii(graph, solid);
    for (std::size_t i = 0; i < radii.size(); ++i) result.branches[i].radii = std::move(radii[i]);
    return result;
}

/// A solid in the length that its descriptors are measured in. The solid's own boundary counts, not
/// the mesh's triangles: soups have walls inside and twice.
struct MeasuredSolid {
    SolidSurface surface;
    double volume = 0.0;  ///< voxels
    double scale = 0.0;   ///< voxels

    explicit MeasuredSolid(const voxel::BitVolume& solid)
        : surface(solid_surface(solid)),
          volume(static_cast<double>(solid.count())),
          scale(body_scale(surface.total_area, volume)) {}
};

matching::SkeletonDescriptor describe_limbs(const skeleton::Skeleton& skeleton,
                                            const MeasuredSolid& solid) {
    matching::SkeletonDescriptor descriptor = matching::describe_skeleton(
        with_tube_radii(skeleton.refined, skeleton.solid.volume), solid.scale);
    const double unit = solid.scale * solid.scale * solid.scale;
    descriptor.solid_volume = static_cast<float>(solid.volume / unit);
    descriptor.limb_volume = static_cast<float>(skeleton::tube_volume(skeleton.refined) / unit);
    return descriptor;
}

/// Options for more grids over what the first one was laid over, as it lay there.
DescribeOptions with_body(const mesh::Body& body, const DescribeOptions& options) {
    DescribeOptions result = options;
    result.skeletonize.voxelize.rotation = body.axes;
    result.skeletonize.voxelize.whole_mesh = true;
    result.skeletonize.canonical_pose = false;
    return result;
}

int turned_resolution(const DescribeOptions& options) {
    const double wanted = options.turned_resolution * options.skeletonize.voxelize.resolution;
    constexpr int kLeast = 8;  // of VoxelizeOptions::resolution
    return std::max(kLeast, static_cast<int>(std::lround(wanted)));
}

/// Further grids are laid while finding the insides has cost no more than this (VoxelSolid::work),
/// a second or so; ordinary models stay a hundred times below.
constexpr std::uint64_t kMostWork = std::uint64_t{1} << 28;

/// Appends the model's skeletons on the turned grids.
/// @param work  that the first grid has cost
/// @param options  without canonical_pose: turned against `voxelize.rotation`
/// Errors: those of skeletonize.
Result<void> trace_turned(const mesh::TriangleMesh& mesh, const DescribeOptions& options,
                          std::uint64_t work, std::vector<matching::SkeletonDescriptor>& skeletons,
                          const std::stop_token& stop) {
    assert(!options.skeletonize.canonical_pose);
    assert(options.turned_grids >= 0 && options.turned_grids <= kMaxTurnedGrids);
    const std::array<Mat3, kMaxTurnedGrids> turns = grid_turns();
    const int resolution = turned_resolution(options);
    for (std::size_t i = 0; i < static_cast<std::size_t>(options.turned_grids); ++i) {
        if (work > kMostWork) break;
        skeleton::SkeletonizeOptions turned = options.skeletonize;
        turned.voxelize.rotation = turned.voxelize.rotation * turns[i];
        turned.voxelize.resolution = resolution;
        turned.refine.significance = false;  // a tenth of the time, and not looked at
        const Result<skeleton::Skeleton> made = skeleton::skeletonize(mesh, turned, stop);
        if (!made) return made.error();
        work += made->solid.work;
        const MeasuredSolid solid(made->solid.volume);
        skeletons.push_back(matching::trace_skeleton(
            with_tube_radii(made->refined, made->solid.volume), solid.scale));
    }
    return {};
}

}  // namespace

Result<Description> describe(const mesh::TriangleMesh& mesh, const DescribeOptions& options,
                             std::stop_token stop) {
    Result<skeleton::Skeleton> made = skeleton::skeletonize(mesh, options.skeletonize, stop);
    if (!made) return made.error();
    const skeleton::Skeleton& skeleton = *made;
    const auto cancelled = [&] { return Error{ErrorCode::kCancelled, "describing was cancelled"}; };

    Description description;
    description.warnings = skeleton.solid.warnings;
    description.stage_times = skeleton.stage_times;
    Stopwatch watch;
    const auto lap = [&](const char* stage) {
        description.stage_times.push_back({stage, watch.lap_ms()});
    };

    const MeasuredSolid solid(skeleton.solid.volume);
    lap("surface");
    if (stop.stop_requested()) return cancelled();

    std::vector<matching::SkeletonDescriptor> skeletons = {describe_limbs(skeleton, solid)};
    lap("describe_skeleton");
    const Result<void> traced =
        trace_turned(skeleton.body.of(mesh), with_body(skeleton.body, options), skeleton.solid.work,
                     skeletons, stop);
    if (!traced) return traced.error();
    lap("turned_skeletons");
    if (stop.stop_requested()) return cancelled();

    description.descriptor.globals = global_descriptors(
        solid.surface, skeleton.solid.volume, skeletons, skeleton.solid.world_from_grid, stop);
    if (stop.stop_requested()) return cancelled();
    description.descriptor.skeleton = std::move(skeletons.front());
    lap("global_descriptors");

    description.descriptor.signature =
        preselection_signature(description.descriptor.skeleton, description.descriptor.globals);
    description.body = std::move(made->body);
    description.skeleton = skeleton::to_world(skeleton.refined, skeleton.solid.world_from_grid);
    lap("signature");
    return description;
}

}  // namespace ossuary::descriptor
