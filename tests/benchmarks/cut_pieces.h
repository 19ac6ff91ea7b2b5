#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

/// Pieces of the models of the segmentation benchmark, cut where people see parts.
namespace ossuary::benchmarks {

/// The faces of `mesh` in `kept` (indices of triangles), as a mesh of their own with a hole where
/// they were cut off.
[[nodiscard]] mesh::TriangleMesh cut_out(const mesh::TriangleMesh& mesh,
                                         const std::vector<std::size_t>& kept);

/// The mesh with a fan over each of its holes, from the middle of the hole's edge.
[[nodiscard]] mesh::TriangleMesh with_holes_closed(const mesh::TriangleMesh& mesh);

struct CutPiece {
    mesh::TriangleMesh mesh;             ///< where the model has it
    std::vector<std::size_t> triangles;  ///< those of the model
    double share = 0.0;                  ///< of the model's area
};

/// One piece of a model that hangs together, has one label in one person's segmentation and from 8
/// to 40 % of the area; which of those that there are goes by `seed`. None where there is none.
/// Throws std::runtime_error for segmentations that cannot be read.
[[nodiscard]] std::optional<CutPiece> cut_piece(const mesh::TriangleMesh& mesh,
                                                const std::filesystem::path& segmentations,
                                                const std::string& name, std::uint64_t seed);

/// Turned, scaled from 0.1 to 10 and moved, at random by `seed`.
[[nodiscard]] mesh::TriangleMesh moved_at_random(const mesh::TriangleMesh& mesh,
                                                 std::uint64_t seed);

}  // namespace ossuary::benchmarks
