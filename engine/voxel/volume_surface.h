#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/voxel/volume.h"

namespace ossuary::voxel {

/// What of a volume is the model; where neither is said, it is found (volume_surface).
struct InsideOptions {
    std::optional<double> threshold;  ///< values of at least this
    std::optional<double> label;      ///< this value alone; goes before `threshold`

    bool operator==(const InsideOptions&) const = default;
};

struct VolumeSurfaceOptions {
    InsideOptions inside;
    int max_side = 256;                     ///< finer volumes are averaged in blocks
    std::size_t max_triangles = 1'000'000;  ///< and so are those whose surface has more
};

struct VolumeSurface {
    mesh::TriangleMesh mesh;  ///< closed, facing outwards, in the volume's own space
    /// Codes: volume_inside (which values were taken, where nobody said so), volume_coarsened (how
    /// many voxels of the file, along each axis, are one), not_finite_voxels (they are outside).
    std::vector<mesh::MeshWarning> warnings;
};

/// The surface of what is inside a volume, with its spacing and directions respected, by dual
/// marching cubes (level_surface.h). What lies outside the volume counts as outside, so that what
/// it cuts off is closed.
///
/// Where nobody says what is inside: of two values the greater, or the one that is
/// not 0; of up to 128 whole numbers from 0
/// up, which are labels, all but 0; else what lies above the threshold that parts the values' own
/// two groups best (Otsu, A Threshold Selection Method from Gray-Level Histograms, 1979).
/// Errors: solid_empty (nothing is inside), invalid_argument (a threshold or label that is not
/// finite), cancelled.
Result<VolumeSurface> volume_surface(const Volume& volume, const VolumeSurfaceOptions& options = {},
                                     const std::stop_token& stop = {});

}  // namespace ossuary::voxel
