#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/descriptor/principal_frame.h"
#include "engine/descriptor/solid_surface.h"

namespace ossuary::descriptor {

/// A picture of a surface, row by row: how far out it is and how squarely it faces the viewer, both
/// in [0, 1]; 0 where there is nothing.
struct ViewImage {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<float> extent;
    std::vector<float> facing;  ///< cosine between the normal and the line of sight
};

inline constexpr std::size_t kPanoramaRows = 64;      ///< along the axis
inline constexpr std::size_t kPanoramaColumns = 128;  ///< around it
inline constexpr std::size_t kDepthSide = 64;

/// The surface projected outwards onto a cylinder about one axis of the frame, the farthest point
/// on each ray (Papadakis, Pratikakis, Theoharis and Perantonis, "PANORAMA: a 3D shape descriptor
/// based on panoramic views for unsupervised 3D object retrieval", IJCV 89, 2010, sec. 3.2). Radius
/// and half the height are three mean distances.
[[nodiscard]] ViewImage panorama(const SolidSurface& surface, const PrincipalFrame& frame,
                                 int axis);

/// The surface seen along one axis of the frame from the positive and the negative side, on the
/// same raster (Vranic, "DESIRE: a composite 3D-shape descriptor", ICME 2005, sec. 3). Half the
/// side is 2.4 mean distances.
[[nodiscard]] std::array<ViewImage, 2> depth_images(const SolidSurface& surface,
                                                    const PrincipalFrame& frame, int axis);

}  // namespace ossuary::descriptor
