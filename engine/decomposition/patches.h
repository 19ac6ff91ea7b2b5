#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/decomposition/surface_graph.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::decomposition {

/// A surface cut into many small patches of like area whose borders follow concave creases, and
/// which patch touches which.
struct PatchGraph {
    struct Patch {
        Vec3 center = Vec3::Zero();  ///< of gravity of its surface
        Vec3 normal = Vec3::Zero();  ///< mean, unit length or zero
        double area = 0.0;
        std::uint32_t triangles = 0;
    };
    struct Link {
        std::uint32_t to = 0;
        double border = 0.0;  ///< length of the common border; 0 between pieces that do not touch
        double concavity =
            0.0;  ///< mean over the border of the turn where it is concave, in [0, 2]
    };
    std::vector<Patch> patches;
    std::vector<std::vector<Link>> links;  ///< of each patch, by ascending `to`; symmetric
    std::vector<std::uint32_t> of_triangle;
    double total_area = 0.0;

    [[nodiscard]] std::size_t size() const { return patches.size(); }
};

struct PatchGraphOptions {
    std::size_t count = 160;
    std::size_t at_least = 0;  ///< patches even of a coarse mesh; not more than it has faces
};

/// Grows `count` patches (fewer on coarse meshes, more where the surface has many pieces) from
/// seeds spread evenly over the area and moved twice to the patches' middles; a step costs its
/// length, and more where the surface bends, most in concave creases (compare the superfacets of
/// Simari, Picciau and De Floriani, "Fast and scalable mesh superfacets", 2014). Pieces below a
/// thousandth of the area join the patch nearest to them, and the nearest patches of larger pieces
/// are linked, so that the graph is connected. A patch holds whole faces. Where there are too few,
/// the largest faces that are not alone become patches of their own.
/// @param mesh  the mesh of `surface`
PatchGraph patch_graph(const mesh::TriangleMesh& mesh, const SurfaceGraph& surface,
                       const PatchGraphOptions& options = {}, const std::stop_token& stop = {});

}  // namespace ossuary::decomposition
