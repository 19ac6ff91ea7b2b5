#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/voxel/voxelize.h"

namespace ossuary::voxel {

/// A position in the grid in fixed point: kGridOne units a voxel. Integers make every decision of
/// the rasteriser exact, so that neighbouring triangles can neither leave a crack nor overlap.
using GridPoint = std::array<std::int32_t, 3>;
inline constexpr int kGridBits = 18;
inline constexpr std::int32_t kGridOne = 1 << kGridBits;
inline constexpr std::int32_t kGridHalf = kGridOne / 2;

/// A mesh laid into the voxel grid: vertices snapped to kGridOne-ths of a voxel. Unless the mesh
/// is closed as it comes, they are welded where they then coincide, and repeated triangles are left
/// out.
struct GridMesh {
    using Triangle = std::array<std::uint32_t, 3>;
    using Segment = std::array<std::uint32_t, 2>;

    Vec3i size;       ///< of the grid, margins included
    Vec3i low, high;  ///< voxels that the bounding box touches: [low, high)
    WorldFromGrid world_from_grid;
    std::vector<GridPoint> points;
    std::vector<Triangle> triangles;  ///< three different points each; no two on the same points
    std::vector<Segment> collapsed;   ///< what is left of triangles with coinciding corners
    /// Every edge is run along as often one way as the other; different points may coincide.
    bool closed = false;
    std::size_t repeated_triangles = 0;

    /// The voxel that holds a position; on the far side of the bounding box, the last one in it.
    [[nodiscard]] Vec3i voxel_of(const GridPoint& p) const {
        return Vec3i(p[0] >> kGridBits, p[1] >> kGridBits, p[2] >> kGridBits)
            .cwiseMin(high - Vec3i::Ones())
            .cwiseMax(low);
    }
};

/// Layers of empty voxels on each side of the bounding box.
inline constexpr int kGridMargin = 2;

/// Errors: mesh_empty, mesh_no_extent, invalid_argument.
Result<GridMesh> lay_into_grid(const mesh::TriangleMesh& mesh, const VoxelizeOptions& options);

}  // namespace ossuary::voxel
