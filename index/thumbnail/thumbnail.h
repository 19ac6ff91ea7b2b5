#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::index {

struct ThumbnailOptions {
    int size = 256;            ///< pixels on each side, in [16, 2048]
    int samples_per_side = 4;  ///< along each side of a pixel at outlines and creases, in [1, 8]
    /// From the model to the viewer, in model space, and what the picture shows upwards. Not
    /// parallel, not zero.
    Vec3 towards_viewer = Vec3(0.55, 0.45, 1.0);
    Vec3 up = Vec3::UnitY();
    double margin = 0.05;                                 ///< empty border, in parts of the picture
    std::array<std::uint8_t, 3> color = {214, 204, 184};  ///< of a mesh without colours, sRGB
    /// Of each triangle instead, and instead of the mesh's own; none, or as many as the mesh has
    /// triangles.
    std::vector<std::array<std::uint8_t, 3>> triangle_colors = {};
    /// sRGB; transparent where none is given.
    std::optional<std::array<std::uint8_t, 3>> background = std::nullopt;
};

/// A square picture: `channels` bytes a pixel (RGBA, or RGB with a background), rows from the top.
struct PixelPicture {
    int size = 0;
    int channels = 0;
    std::vector<std::uint8_t> bytes;
};

/// As render_thumbnail, but as pixels.
Result<PixelPicture> render_pixels(const mesh::TriangleMesh& mesh,
                                   const ThumbnailOptions& options = {},
                                   const std::stop_token& stop = {});

/// Draws a model from three quarters, framed to fill the picture, as a PNG file's bytes (RGBA, or
/// RGB with a background). Surfaces are lit from both sides, so that soups with facets turned over
/// look whole; facets that meet at less than 45 degrees are shaded as one curved surface. The same
/// mesh gives the same bytes on the same machine. Runs on the calling thread.
/// Errors: mesh_empty, mesh_no_extent, invalid_argument, out_of_memory, cancelled.
Result<std::vector<std::uint8_t>> render_thumbnail(const mesh::TriangleMesh& mesh,
                                                   const ThumbnailOptions& options = {},
                                                   const std::stop_token& stop = {});

}  // namespace ossuary::index
