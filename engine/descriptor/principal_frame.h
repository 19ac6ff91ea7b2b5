#pragma once

#include "engine/core/geometry.h"
#include "engine/descriptor/solid_surface.h"

namespace ossuary::descriptor {

/// Which covariance gives a frame its axes.
enum class FrameKind {
    kPositions,  ///< of the surface's points: long axes first
    kNormals,    ///< of its normals: the main walls face the axes
};

/// A frame of a surface's own: where it is, how it is turned, how large it is.
struct PrincipalFrame {
    Vec3 center = Vec3::Zero();    ///< of gravity of the surface, grid units
    Mat3 axes = Mat3::Identity();  ///< one a row, greatest variance first; signs are arbitrary
    double mean_distance = 1.0;    ///< of the surface from the centre, voxels; > 0
};

/// @pre the surface is not empty
[[nodiscard]] PrincipalFrame principal_frame(const SolidSurface& surface, FrameKind kind);

}  // namespace ossuary::descriptor
