#include <benchmark/benchmark.h>

#include "engine/descriptor/describe.h"
#include "engine/ranking/ranker.h"
#include "tests/benchmarks/workload.h"

namespace ossuary::benchmarks {
namespace {

constexpr std::size_t kCollectionSize = 380;

// A collection of the workloads' descriptors over and over: what a search's ranking costs.
void time_ranking(benchmark::State& state, ranking::RankerKind ranker) {
    std::vector<descriptor::ModelDescriptor> descriptors;
    for (const Workload& workload : workloads()) {
        descriptors.push_back(descriptor::describe(workload.mesh)->descriptor);
    }
    std::vector<const descriptor::ModelDescriptor*> collection;
    for (std::size_t i = 0; i < kCollectionSize; ++i) {
        collection.push_back(&descriptors[i % descriptors.size()]);
    }
    const ranking::CollectionStatistics statistics = *ranking::collection_statistics(collection);
    ranking::RankOptions options;
    options.ranker = ranker;
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            *ranking::rank_distances(descriptors.front(), collection, statistics, options));
    }
}

}  // namespace

void register_describe_benchmarks() {
    for (const Workload& workload : workloads()) {
        benchmark::RegisterBenchmark(("describe/" + workload.name).c_str(), [&](benchmark::State&
                                                                                    state) {
            for (auto _ : state) {
                benchmark::DoNotOptimize(descriptor::describe(workload.mesh));
            }
        })->Unit(benchmark::kMillisecond);
    }
    for (const ranking::RankerKind ranker : ranking::kAllRankers) {
        benchmark::RegisterBenchmark(
            ("rank_380/" + std::string(to_string(ranker))).c_str(),
            [ranker](benchmark::State& state) { time_ranking(state, ranker); })
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace ossuary::benchmarks
