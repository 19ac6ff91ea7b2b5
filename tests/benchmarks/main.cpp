// Times every stage of the engine on named workloads. `ossuary_benchmark --benchmark_list_tests`
// prints the menu; `--benchmark_filter=thin_anchored/.*` picks from it; `--benchmark_format=csv`
// writes what docs/ keeps.
#include <benchmark/benchmark.h>

#include "tests/benchmarks/workload.h"

int main(int argc, char** argv) {
    using namespace ossuary::benchmarks;
    register_mesh_benchmarks();
    register_voxel_benchmarks();
    register_skeleton_benchmarks();
    register_matching_benchmarks();
    register_describe_benchmarks();
    register_search_benchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
