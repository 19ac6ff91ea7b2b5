#include <benchmark/benchmark.h>

#include "engine/skeleton/skeletonize.h"
#include "tests/benchmarks/workload.h"

namespace ossuary::benchmarks {
namespace {

void time_thinning(benchmark::State& state, const Workload& workload,
                   skeleton::ThinningMethod method) {
    voxel::VoxelizeOptions voxels;
    voxels.resolution = static_cast<int>(state.range(0));
    const voxel::VoxelSolid solid = *voxel::voxelize(workload.mesh, voxels);
    const voxel::DistanceField distance = voxel::distance_transform(solid.volume);
    skeleton::ThinningOptions options;
    options.method = method;
    for (auto _ : state) benchmark::DoNotOptimize(skeleton::thin(solid.volume, distance, options));
    state.counters["voxels"] = static_cast<double>(solid.volume.count());
}

}  // namespace

void register_skeleton_benchmarks() {
    for (const Workload& workload : workloads()) {
        const auto name = [&](const char* stage) { return stage + ("/" + workload.name); };
        benchmark::RegisterBenchmark(name("thin_anchored").c_str(),
                                     [&](benchmark::State& state) {
                                         time_thinning(state, workload,
                                                       skeleton::ThinningMethod::kAnchored);
                                     })
            ->Arg(96)
            ->Arg(128)
            ->Arg(256)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(name("thin_parallel").c_str(),
                                     [&](benchmark::State& state) {
                                         time_thinning(state, workload,
                                                       skeleton::ThinningMethod::kParallel);
                                     })
            ->Arg(96)
            ->Arg(128)
            ->Arg(256)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(name("refine").c_str(), [&](benchmark::State& state) {
            const skeleton::Skeleton skeleton = *skeleton::skeletonize(workload.mesh);
            std::vector<Vec3> surface;
            for (const Vec3& vertex : workload.mesh.vertices) {
                surface.push_back(skeleton.solid.world_from_grid.grid(vertex));
            }
            for (auto _ : state)
                benchmark::DoNotOptimize(skeleton::refine(skeleton.thinned, surface));
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(name("skeletonize").c_str(), [&](benchmark::State& state) {
            for (auto _ : state) benchmark::DoNotOptimize(skeleton::skeletonize(workload.mesh));
        })->Unit(benchmark::kMillisecond);
    }
}

}  // namespace ossuary::benchmarks
