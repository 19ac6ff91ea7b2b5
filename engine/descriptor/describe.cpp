#include "engine/descriptor/describe.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "engine/core/parallel.h"
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
    // They are laid beside the first one, which tells how far it is.
    result.skeletonize.on_stage = {};
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

/// What describing a model finds out on the first grid.
struct FirstGrid {
    Result<skeleton::Skeleton> made = Error{ErrorCode::kCancelled, "describing was cancelled"};
    matching::SkeletonDescriptor limbs;
    std::vector<GlobalDescriptor> globals;  ///< those of the solid
    StageTimes stage_times;
    double solid_ms = 0.0;  ///< of them, for `globals`
};

FirstGrid look_at_first_grid(const mesh::TriangleMesh& mesh, mesh::Body body,
                             const DescribeOptions& options, const std::stop_token& stop) {
    FirstGrid first;
    first.made = skeleton::skeletonize(mesh, std::move(body), options.skeletonize, stop);
    if (!first.made) return first;
    const skeleton::Skeleton& skeleton = *first.made;
    first.stage_times = skeleton.stage_times;
    const StageReport& on_stage = options.skeletonize.on_stage;
    Stopwatch watch;
    if (on_stage) on_stage("surface");
    const MeasuredSolid solid(skeleton.solid.volume);
    first.stage_times.push_back({"surface", watch.lap_ms()});
    if (stop.stop_requested()) return first;
    if (on_stage) on_stage("describe_skeleton");
    first.limbs = describe_limbs(skeleton, solid);
    first.stage_times.push_back({"describe_skeleton", watch.lap_ms()});
    if (on_stage) on_stage("global_descriptors");
    first.globals = solid_descriptors(solid.surface, skeleton.solid.volume,
                                      skeleton.solid.world_from_grid, stop);
    first.solid_ms = watch.lap_ms();
    if (on_stage) on_stage("turned_skeletons");
    return first;
}

/// The model's skeleton on a turned grid.
struct TurnedGrid {
    std::optional<Result<matching::SkeletonDescriptor>> skeleton;  ///< none where it was not laid
    std::atomic<std::uint64_t> work = 0;                           ///< that it has cost
};

/// @param options  without canonical_pose: turned against `voxelize.rotation`
void trace_turned(const mesh::TriangleMesh& mesh, const DescribeOptions& options, std::size_t turn,
                  TurnedGrid& grid, const std::stop_token& stop) {
    assert(!options.skeletonize.canonical_pose);
    skeleton::SkeletonizeOptions turned = options.skeletonize;
    turned.voxelize.rotation = turned.voxelize.rotation * grid_turns()[turn];
    turned.voxelize.resolution = turned_resolution(options);
    turned.refine.significance = false;  // a tenth of the time, and not looked at
    const Result<skeleton::Skeleton> made = skeleton::skeletonize(mesh, turned, stop);
    if (!made) {
        grid.skeleton = Result<matching::SkeletonDescriptor>(made.error());
        return;
    }
    grid.work = made->solid.work;
    const MeasuredSolid solid(made->solid.volume);
    grid.skeleton = Result<matching::SkeletonDescriptor>(
        matching::trace_skeleton(with_tube_radii(made->refined, made->solid.volume), solid.scale));
}

/// Appends the skeletons of the grids that count: up to the one before which the work was too much.
/// Errors: those of skeletonize.
Result<void> take_turned(std::uint64_t work, std::span<TurnedGrid> grids,
                         std::vector<matching::SkeletonDescriptor>& skeletons) {
    for (TurnedGrid& grid : grids) {
        if (work > kMostWork) break;
        assert(grid.skeleton);
        if (!*grid.skeleton) return grid.skeleton->error();
        work += grid.work;
        skeletons.push_back(**std::move(grid.skeleton));
    }
    return {};
}

}  // namespace

Result<Description> describe(const mesh::TriangleMesh& mesh, const DescribeOptions& options,
                             std::stop_token stop) {
    const auto cancelled = [] { return Error{ErrorCode::kCancelled, "describing was cancelled"}; };
    assert(options.turned_grids >= 0 && options.turned_grids <= kMaxTurnedGrids);
    if (stop.stop_requested()) return cancelled();
    Stopwatch watch;
    const mesh::Body body = skeleton::find_body(mesh, options.skeletonize, stop);
    const double body_ms = watch.lap_ms();

    // The first grid costs about as much as all others, and is begun first.
    FirstGrid first;
    std::atomic<std::uint64_t> first_work = 0;
    std::vector<TurnedGrid> grids(static_cast<std::size_t>(options.turned_grids));
    const DescribeOptions turned = with_body(body, options);
    parallel_for(grids.size() + 1, options.jobs, [&](std::size_t i) {
        if (i == 0) {
            first = look_at_first_grid(mesh, body, options, stop);
            first_work = first.made ? first.made->solid.work : kMostWork + 1;
            return;
        }
        // Grids before this one may not be done: whether it counts is decided when all are.
        std::uint64_t work = first_work;
        for (std::size_t before = 0; before + 1 < i; ++before) work += grids[before].work;
        if (work <= kMostWork) trace_turned(body.of(mesh), turned, i - 1, grids[i - 1], stop);
    });
    if (!first.made) return first.made.error();
    if (stop.stop_requested()) return cancelled();
    const skeleton::Skeleton& skeleton = *first.made;

    Description description;
    description.warnings = skeleton.solid.warnings;
    description.stage_times = std::move(first.stage_times);
    description.stage_times.front().milliseconds += body_ms;
    double waited = watch.lap_ms() - first.solid_ms + body_ms;
    for (const StageTime& stage : description.stage_times) waited -= stage.milliseconds;
    description.stage_times.push_back({"turned_skeletons", std::max(waited, 0.0)});

    std::vector<matching::SkeletonDescriptor> skeletons = {std::move(first.limbs)};
    const Result<void> taken = take_turned(skeleton.solid.work, grids, skeletons);
    if (!taken) return taken.error();
    if (options.skeletonize.on_stage) options.skeletonize.on_stage("global_descriptors");
    description.descriptor.globals = skeleton_descriptors(skeletons, stop);
    if (stop.stop_requested()) return cancelled();
    description.descriptor.globals.insert(description.descriptor.globals.end(),
                                          std::make_move_iterator(first.globals.begin()),
                                          std::make_move_iterator(first.globals.end()));
    description.descriptor.skeleton = std::move(skeletons.front());
    description.stage_times.push_back({"global_descriptors", first.solid_ms + watch.lap_ms()});

    description.descriptor.signature =
        preselection_signature(description.descriptor.skeleton, description.descriptor.globals);
    description.skeleton = skeleton::to_world(skeleton.refined, skeleton.solid.world_from_grid);
    description.body = std::move(first.made->body);
    description.stage_times.push_back({"signature", watch.lap_ms()});
    return description;
}

}  // namespace ossuary::descriptor
