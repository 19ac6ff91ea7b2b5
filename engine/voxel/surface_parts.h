#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/voxel/grid_mesh.h"

namespace ossuary::voxel {

/// A surface taken apart for inside tests.
struct SurfaceParts {
    enum class Kind : std::uint8_t {
        kOriented,  ///< closed, with one orientation throughout: winding numbers are defined
        kEven,      ///< every edge an even number of times: closed, inside by parity only
        kOpen,      ///< has a border
    };
    std::vector<std::uint32_t> part_of;  ///< for each triangle
    std::vector<Kind> kinds;             ///< for each part
    std::size_t open_triangles = 0;

    [[nodiscard]] std::size_t count() const { return kinds.size(); }
};

/// Splits the mesh into pieces that share points. A piece that is not closed with the orientation
/// it came with is split at the edges where other than two triangles meet, its patches are given
/// one orientation each (turning triangles of `mesh` over), and those that then are closed become
/// parts of their own; what remains is open, in pieces that share points.
SurfaceParts find_parts(GridMesh& mesh);

}  // namespace ossuary::voxel
