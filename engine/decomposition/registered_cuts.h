#pragma once

#include <vector>

#include "engine/core/geometry.h"
#include "engine/decomposition/segmentation.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::decomposition {

/// A closed line between two parts: connected edges of the mesh with the same two parts beside
/// them.
struct Cut {
    std::vector<Vec3> nodes;  ///< the middles of its edges
    double length = 0.0;
    Vec3 center = Vec3::Zero();  ///< of gravity
    double radius = 0.0;         ///< of the ball around the centre that holds the nodes
};

/// @param edges  of the mesh
/// @param segmentation  a label for each triangle
/// @returns the cuts in the order of their first edge
std::vector<Cut> find_cuts(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& edges,
                           const Segmentation& segmentation);

/// How far the cuts of a segmentation are from those of a reference (thesis sec. 4.3), in the
/// mesh's unit.
struct RegisteredCuts {
    std::size_t pairs = 0;
    /// Sum over the pairs of the mean distance of the nodes of each from the nearest of the other.
    double distance = 0.0;
    double additional = 0.0;  ///< length of the cuts without a counterpart in the reference
    double missing = 0.0;     ///< length of the reference's without one; not part of the measure

    /// The thesis' measure, before it is normalised.
    [[nodiscard]] double total() const { return distance + additional; }
};

/// Pairs the nearest cuts, each with one at most. The thesis does so by hand; here a pair is made
/// where it adds less to the measure than the cut would that is left without one.
RegisteredCuts register_cuts(const std::vector<Cut>& reference, const std::vector<Cut>& made);

}  // namespace ossuary::decomposition
