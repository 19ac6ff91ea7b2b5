#include <benchmark/benchmark.h>

#include "engine/voxel/betti.h"
#include "engine/voxel/distance_transform.h"
#include "engine/voxel/voxelize.h"
#include "tests/benchmarks/workload.h"

namespace ossuary::benchmarks {
namespace {

voxel::VoxelSolid solid_of(const Workload& workload, std::int64_t resolution) {
    voxel::VoxelizeOptions options;
    options.resolution = static_cast<int>(resolution);
    return *voxel::voxelize(workload.mesh, options);
}

}  // namespace

void register_voxel_benchmarks() {
    for (const Workload& workload : workloads()) {
        const auto name = [&](const char* stage) { return stage + ("/" + workload.name); };
        benchmark::RegisterBenchmark(
            name("voxelize").c_str(),
            [&](benchmark::State& state) {
                for (auto _ : state) benchmark::DoNotOptimize(solid_of(workload, state.range(0)));
            })
            ->Arg(96)
            ->Arg(128)
            ->Arg(256)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(
            name("distance_transform").c_str(),
            [&](benchmark::State& state) {
                const voxel::VoxelSolid solid = solid_of(workload, state.range(0));
                for (auto _ : state)
                    benchmark::DoNotOptimize(voxel::distance_transform(solid.volume));
            })
            ->Arg(96)
            ->Arg(128)
            ->Arg(256)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(
            name("betti_numbers").c_str(),
            [&](benchmark::State& state) {
                const voxel::VoxelSolid solid = solid_of(workload, state.range(0));
                for (auto _ : state) benchmark::DoNotOptimize(voxel::betti_numbers(solid.volume));
            })
            ->Arg(96)
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace ossuary::benchmarks
