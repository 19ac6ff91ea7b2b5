#pragma once

#include <string>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::benchmarks {

/// A model that the stages are timed on.
struct Workload {
    std::string name;
    mesh::TriangleMesh mesh;
    std::string off;  ///< the same as the bytes of an .off file
};

/// Built shapes that are always there (a torus, a tree of capsules) and, where the benchmark
/// collections are at hand, five of their models: a human, a cup, an ant, a hand, an armadillo.
const std::vector<Workload>& workloads();

// Each registers its benchmarks for every workload, as stage/workload.
void register_mesh_benchmarks();
void register_voxel_benchmarks();
void register_skeleton_benchmarks();
void register_matching_benchmarks();
void register_describe_benchmarks();
// For collections of several sizes instead, with the recall of the exact ten nearest.
void register_search_benchmarks();

}  // namespace ossuary::benchmarks
