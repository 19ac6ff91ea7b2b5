#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/decomposition/segmentation.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/geodesics.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::decomposition {

/// How far the cuts of segmentations of one mesh lie apart, as the Princeton benchmark measures it
/// (Chen, Golovinskiy and Funkhouser, 2009, sec. 4.1): the mean distance, along the edges of the
/// mesh, from each vertex on a cut of the one to the nearest on a cut of the other, both ways
/// together, over the mean distance of the surface from its centre of gravity.
class CutDiscrepancy {
public:
    explicit CutDiscrepancy(const mesh::TriangleMesh& mesh);

    /// A segmentation's cuts with the distance of every vertex from them.
    struct Cuts {
        std::vector<std::uint32_t> vertices;  ///< ends of edges between two parts
        std::vector<double> distances;        ///< model units; empty without cuts
    };
    /// @param segmentation  a label for each triangle of the mesh
    [[nodiscard]] Cuts cuts_of(const Segmentation& segmentation) const;

    /// 0 where neither is cut; nothing where only one is (the measure is not defined then).
    [[nodiscard]] std::optional<double> operator()(const Cuts& a, const Cuts& b) const;

private:
    mesh::EdgeTable edges_;
    mesh::GeodesicGraph graph_;
    std::size_t vertex_count_;
    double average_radius_ = 0.0;  ///< model units
};

}  // namespace ossuary::decomposition
