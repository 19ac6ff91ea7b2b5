#include <benchmark/benchmark.h>

#include "engine/mesh/decimate.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/read_mesh.h"
#include "tests/benchmarks/workload.h"

namespace ossuary::benchmarks {

void register_mesh_benchmarks() {
    for (const Workload& workload : workloads()) {
        const auto name = [&](const char* stage) { return stage + ("/" + workload.name); };
        benchmark::RegisterBenchmark(name("read_off").c_str(), [&](benchmark::State& state) {
            for (auto _ : state) {
                auto read = mesh::read_mesh(workload.off, workload.name);
                if (!read.ok()) state.SkipWithError(read.error().message.c_str());
                benchmark::DoNotOptimize(read);
            }
            state.SetBytesProcessed(static_cast<std::int64_t>(workload.off.size()) *
                                    state.iterations());
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(name("inspect").c_str(), [&](benchmark::State& state) {
            for (auto _ : state) benchmark::DoNotOptimize(mesh::inspect(workload.mesh));
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(name("decimate").c_str(), [&](benchmark::State& state) {
            for (auto _ : state) benchmark::DoNotOptimize(mesh::decimate(workload.mesh));
        })->Unit(benchmark::kMillisecond);
    }
}

}  // namespace ossuary::benchmarks
