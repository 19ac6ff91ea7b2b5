#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/colour.h"

namespace ossuary::mesh {

/// A triangle soup with shared vertices: what every stage reads. It holds whatever a file may say
/// (open, non-manifold, degenerate, several pieces); connectivity is asked of HalfedgeMesh.
struct TriangleMesh {
    using Triangle = std::array<std::uint32_t, 3>;

    std::vector<Vec3> vertices;       ///< model units
    std::vector<Triangle> triangles;  ///< indices into `vertices`, each in range
    /// The polygon of the source file that each triangle was cut from, as long as `triangles`.
    /// Polygons that gave no triangle (fewer than three corners) are counted in `face_count`.
    std::vector<std::uint32_t> face_of_triangle;
    std::uint32_t face_count = 0;  ///< polygons in the source
    /// As long as `triangles`; empty where the source has none. Only pictures ask.
    std::vector<CornerColours> corner_colours = {};

    [[nodiscard]] bool empty() const { return triangles.empty(); }
    [[nodiscard]] std::array<Vec3, 3> corners(std::size_t triangle) const {
        const Triangle& t = triangles[triangle];
        return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    }
    /// Lets a triangle face the other way.
    void turn_over(std::size_t triangle) {
        std::swap(triangles[triangle][1], triangles[triangle][2]);
        if (corner_colours.empty()) return;
        std::swap(corner_colours[triangle][1], corner_colours[triangle][2]);
    }
};

/// Something odd about a mesh that does not keep it from being used.
struct MeshWarning {
    std::string code;       ///< stable, snake_case: degenerate_faces, non_manifold_edges, …
    std::size_t count = 0;  ///< how often
    std::string message;    ///< for people
};

}  // namespace ossuary::mesh
