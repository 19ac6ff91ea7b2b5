#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::decomposition {

/// A model that can be moved by its skeleton (thesis sec. 4.1.2): a tree of joints, and how much
/// each vertex follows which of them.
struct Rig {
    struct Joint {
        Vec3 position = Vec3::Zero();  ///< in the mesh's units
        std::int32_t parent = -1;      ///< an earlier joint; -1 for the first
        std::int32_t branch = -1;  ///< of the skeleton that turns about it; -1 for the first, and
                                   ///< for the tips, which nothing follows
    };
    static constexpr std::size_t kInfluences = 4;
    struct Weights {
        std::array<std::uint16_t, kInfluences> joints{};
        std::array<float, kInfluences> weights{};  ///< descending, sum 1
    };
    std::vector<Joint> joints;
    std::vector<Weights> weights;  ///< of each vertex of the mesh
};

inline constexpr int kRigSmoothing = 12;

/// The first joint is the thickest node of the skeleton; every branch has a joint where it leaves
/// the side of that node (loops are parted where the ways around them meet), and one more at its
/// tip where it ends without another, so that there is something to take it by. Vertices first
/// follow
/// the branch that they are mapped to (branch_mapping.h); then the weights are spread over the
/// surface, `smoothing` times half to the neighbours, and the four largest kept.
/// @param skeleton  refined, in the mesh's units; without branches all follow the first joint
/// @param stop      once asked to stop, it returns soon, without weights
Rig make_rig(const mesh::TriangleMesh& mesh, const skeleton::SkeletonGraph& skeleton,
             int smoothing = kRigSmoothing, const std::stop_token& stop = {});

}  // namespace ossuary::decomposition
