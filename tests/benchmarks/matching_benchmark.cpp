#include <benchmark/benchmark.h>

#include "engine/descriptor/describe.h"
#include "engine/matching/match_chain_codes.h"
#include "engine/matching/match_skeletons.h"
#include "engine/ranking/pair_distances.h"
#include "tests/benchmarks/workload.h"

namespace ossuary::benchmarks {
namespace {

// The workload's descriptor and the next workload's: two different models.
std::pair<descriptor::ModelDescriptor, descriptor::ModelDescriptor> pair_of(std::size_t index) {
    const auto& all = workloads();
    return {descriptor::describe(all[index].mesh)->descriptor,
            descriptor::describe(all[(index + 1) % all.size()].mesh)->descriptor};
}

}  // namespace

void register_matching_benchmarks() {
    for (std::size_t i = 0; i < workloads().size(); ++i) {
        const std::string workload = workloads()[i].name;
        benchmark::RegisterBenchmark(("skeleton_distance/" + workload).c_str(),
                                     [i](benchmark::State& state) {
                                         const auto [a, b] = pair_of(i);
                                         matching::SkeletonMatchWorkspace workspace;
                                         for (auto _ : state) {
                                             benchmark::DoNotOptimize(matching::skeleton_distance(
                                                 a.skeleton, b.skeleton, {}, workspace));
                                         }
                                     })
            ->Unit(benchmark::kMicrosecond);
        benchmark::RegisterBenchmark(("chain_code_distance/" + workload).c_str(),
                                     [i](benchmark::State& state) {
                                         const auto [a, b] = pair_of(i);
                                         matching::ChainCodeMatchWorkspace workspace;
                                         for (auto _ : state) {
                                             benchmark::DoNotOptimize(matching::chain_code_distance(
                                                 a.skeleton, b.skeleton, {}, workspace));
                                         }
                                     })
            ->Unit(benchmark::kMicrosecond);
        benchmark::RegisterBenchmark(("pose_distance/" + workload).c_str(),
                                     [i](benchmark::State& state) {
                                         const auto [a, b] = pair_of(i);
                                         for (auto _ : state) {
                                             benchmark::DoNotOptimize(ranking::pose_distance(a, b));
                                         }
                                     })
            ->Unit(benchmark::kMicrosecond);
        benchmark::RegisterBenchmark(("match_skeletons/" + workload).c_str(), [i](benchmark::State&
                                                                                      state) {
            const auto [a, b] = pair_of(i);
            for (auto _ : state) {
                benchmark::DoNotOptimize(matching::match_skeletons(a.skeleton, b.skeleton));
            }
        })->Unit(benchmark::kMicrosecond);
    }
}

}  // namespace ossuary::benchmarks
