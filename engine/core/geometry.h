#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ossuary {

using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;
using Vec3i = Eigen::Vector3i;
using Mat3 = Eigen::Matrix3d;
using Box3 = Eigen::AlignedBox3d;

/// Maps voxel coordinates to the model's own: the voxel (i, j, k) covers the cube from (i, j, k) to
/// (i+1, j+1, k+1) in grid space, its centre is (i+.5, j+.5, k+.5), and
/// world = origin + rotation * (voxel_size * grid).
struct WorldFromGrid {
    Vec3 origin = Vec3::Zero();
    double voxel_size = 1.0;           ///< world units a voxel
    Mat3 rotation = Mat3::Identity();  ///< the grid's axes in the world; may mirror

    [[nodiscard]] Vec3 point(const Vec3& grid) const {
        return origin + rotation * (voxel_size * grid);
    }
    [[nodiscard]] double length(double voxels) const { return voxel_size * voxels; }
    [[nodiscard]] Vec3 grid(const Vec3& world) const {
        return rotation.transpose() * (world - origin) / voxel_size;
    }
};

}  // namespace ossuary
