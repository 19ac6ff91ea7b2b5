#include "engine/descriptor/principal_frame.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>

namespace ossuary::descriptor {
namespace {

constexpr double kLeastDistance = 0.5;  // voxels; the surface of a single voxel

}  // namespace

PrincipalFrame principal_frame(const SolidSurface& surface, FrameKind kind) {
    assert(!surface.empty());
    PrincipalFrame frame;
    const auto weight = [&](std::size_t i) {
        return static_cast<double>(surface.areas[i]) / surface.total_area;
    };
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        frame.center += weight(i) * surface.points[i].cast<double>();
    }
    Mat3 covariance = Mat3::Zero();
    double mean_distance = 0.0;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const Vec3 offset = surface.points[i].cast<double>() - frame.center;
        mean_distance += weight(i) * offset.norm();
        const Vec3 v =
            kind == FrameKind::kPositions ? offset : Vec3(surface.normals[i].cast<double>());
        covariance += weight(i) * v * v.transpose();
    }
    frame.mean_distance = std::max(mean_distance, kLeastDistance);
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
    for (int axis = 0; axis < 3; ++axis) {
        frame.axes.row(axis) = solver.eigenvectors().col(2 - axis).transpose();
    }
    return frame;
}

}  // namespace ossuary::descriptor
