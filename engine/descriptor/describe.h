#pragma once

#include <stop_token>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/stopwatch.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/skeleton/skeletonize.h"

namespace ossuary::descriptor {

struct DescribeOptions {
    skeleton::SkeletonizeOptions skeletonize;
    /// Skeletons on coarser grids turned against the first one, at most kMaxTurnedGrids, over which
    /// the descriptors that need no matching are averaged: where thinning decides by a voxel, each
    /// decides anew.
    int turned_grids = 6;
    double turned_resolution = 2.0 / 3.0;  ///< of skeletonize.voxelize.resolution
    int jobs = 1;  ///< threads that the grids are shared among; 0 = one a hardware thread
};
inline constexpr int kMaxTurnedGrids = 6;

/// All that the index keeps of a model and the rankers need of a query.
struct Description {
    ModelDescriptor descriptor;
    mesh::Body body;  ///< what of the mesh was described
    skeleton::SkeletonGraph
        skeleton;  ///< refined, in the model's own units; what correspondences index into
    std::vector<mesh::MeshWarning> warnings;
    StageTimes stage_times;
};

/// The whole road from a mesh to its descriptor; the same, bit by bit, for every number of jobs.
/// Errors: those of skeletonize.
Result<Description> describe(const mesh::TriangleMesh& mesh, const DescribeOptions& options = {},
                             std::stop_token stop = {});

}  // namespace ossuary::descriptor
