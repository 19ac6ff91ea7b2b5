#pragma once

#include <vector>

#include "engine/core/geometry.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::descriptor {

/// The boundary of a solid as points with normals and areas: one point a border voxel. Every global
/// descriptor reads this, so that open meshes, soups and watertight models are described alike.
struct SolidSurface {
    std::vector<Vec3i> voxels;   ///< x fastest, then y, then z
    std::vector<Vec3f> points;   ///< the voxels' centres moved onto the boundary; grid units
    std::vector<Vec3f> normals;  ///< unit length, outwards
    std::vector<float> areas;    ///< voxels squared; free of the staircase's excess
    double total_area = 0.0;

    [[nodiscard]] bool empty() const { return points.empty(); }
};

/// The normal of a border voxel points away from the centre of gravity of the solid within three
/// voxels; its area is the number of its open faces over the normal's 1-norm, which is exact for
/// every plane.
SolidSurface solid_surface(const voxel::BitVolume& solid);

/// Half the resolution: a voxel is set where any of its eight is.
voxel::BitVolume halve(const voxel::BitVolume& solid);

}  // namespace ossuary::descriptor
