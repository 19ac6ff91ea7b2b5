#pragma once

#include <stop_token>

#include "engine/core/result.h"
#include "engine/core/stage_report.h"
#include "engine/core/stopwatch.h"
#include "engine/mesh/body.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/skeleton/refine.h"
#include "engine/skeleton/skeleton_graph.h"
#include "engine/skeleton/thinning.h"
#include "engine/voxel/voxelize.h"

namespace ossuary::skeleton {

struct SkeletonizeOptions {
    /// Lay the grid along the model's own axes (canonical_pose.h), so that the skeleton does not
    /// depend on how the model is turned or mirrored; `voxelize.rotation` is then not used.
    bool canonical_pose = true;
    voxel::VoxelizeOptions voxelize;
    ThinningOptions thinning;
    RefineOptions refine;
    StageReport on_stage = {};
};

/// A model's skeleton at each stage of its making; graphs are in voxel units of `solid`'s grid.
struct Skeleton {
    mesh::Body body;  ///< what of the mesh it is the skeleton of
    voxel::VoxelSolid solid;
    voxel::DistanceField distance;
    voxel::BitVolume thinned_volume;
    SkeletonGraph thinned;
    SkeletonGraph pruned;
    SkeletonGraph refined;
    StageTimes stage_times;  ///< voxelize, distance_transform, thin, refine
};

/// mesh → voxels → distance transform → thinning → graph → refinement (thesis sec. 3.2). The
/// surface of eq. 3.3 is the mesh's vertices, as in the thesis (surface_points.h): a coarse mesh
/// gives nodes large distances and so large significances.
/// Errors: those of voxelize, and cancelled when `stop` is requested between stages.
Result<Skeleton> skeletonize(const mesh::TriangleMesh& mesh, const SkeletonizeOptions& options = {},
                             std::stop_token stop = {});

/// What of a mesh `skeletonize` looks at, and the axes that its grid is laid along.
[[nodiscard]] mesh::Body find_body(const mesh::TriangleMesh& mesh,
                                   const SkeletonizeOptions& options,
                                   const std::stop_token& stop = {});

/// The same of a body that is known. Errors: the same.
Result<Skeleton> skeletonize(const mesh::TriangleMesh& mesh, mesh::Body body,
                             const SkeletonizeOptions& options, std::stop_token stop = {});

}  // namespace ossuary::skeleton
