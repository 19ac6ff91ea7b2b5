#include "engine/voxel/volume_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "engine/mesh/mesh_builder.h"
#include "engine/voxel/choose_inside.h"
#include "engine/voxel/level_surface.h"
#include "engine/voxel/scalar_grid.h"
#include "engine/voxel/volume_values.h"

namespace ossuary::voxel {
namespace {

/// What is inside as numbers of at least 0.5: shares of a block that are, or values by their place
/// between the volume's extremes, of which the threshold is 0.5.
class InsideGrid {
public:
    InsideGrid(const Volume& volume, const Inside& inside, int block)
        : volume_(volume), inside_(inside), block_(block) {
        const Vec3i blocks = (volume.size.array() + (block - 1)) / block;
        grid_ = ScalarGrid(blocks + Vec3i::Constant(2));
        grid_.axes = volume.axes * block;
        // The middle of the first block, and one block of outside before it.
        grid_.origin = volume.origin + volume.axes * Vec3::Constant((block - 1) / 2.0 - block);
    }

    /// False where it was stopped.
    bool fill(const std::stop_token& stop) {
        const bool done = visit_values(volume_, stop, [&](const Vec3i& voxel, double value) {
            const Vec3i at = voxel / block_ + Vec3i::Ones();
            grid_.at(at.x(), at.y(), at.z()) += share_of(value);
        });
        if (block_ > 1) average();
        return done;
    }
    [[nodiscard]] const ScalarGrid& grid() const { return grid_; }

private:
    /// 0.5 at the threshold, 0 at or below as far under it as the greatest value is above it, 1 at
    /// the greatest.
    [[nodiscard]] float share_of(double value) const {
        if (inside_.kind != Inside::Kind::kLevel) return inside_.has(value) ? 1.0F : 0.0F;
        if (!(value > -std::numeric_limits<double>::infinity())) return 0.0F;  // nor NaN
        const double above = inside_.greatest / 2 - inside_.value / 2;
        if (!(above > 0)) return value >= inside_.value ? 1.0F : 0.0F;
        const double share = 0.5 + (value / 2 - inside_.value / 2) / above / 2;
        // Rounding to a float must not bring a value across.
        return static_cast<float>(value >= inside_.value ? std::clamp(share, 0.5, 1.0)
                                                         : std::clamp(share, 0.0, 0.4999999));
    }

    void average() {
        for (int z = 1; z + 1 < grid_.size.z(); ++z) {
            for (int y = 1; y + 1 < grid_.size.y(); ++y) {
                for (int x = 1; x + 1 < grid_.size.x(); ++x) {
                    const Vec3i first = Vec3i(x - 1, y - 1, z - 1) * block_;
                    const Vec3i voxels = (volume_.size - first).cwiseMin(Vec3i::Constant(block_));
                    grid_.at(x, y, z) /= static_cast<float>(voxels.prod());
                }
            }
        }
    }

    const Volume& volume_;
    const Inside& inside_;
    int block_;
    ScalarGrid grid_;
};

constexpr float kShare = 0.5F;

/// Of the level's surface.
std::size_t triangles_of(const ScalarGrid& grid) {
    std::size_t crossings = 0;
    for (int z = 0; z + 1 < grid.size.z(); ++z) {
        for (int y = 0; y + 1 < grid.size.y(); ++y) {
            for (int x = 0; x + 1 < grid.size.x(); ++x) {
                const bool here = grid.at(x, y, z) >= kShare;
                crossings += here != (grid.at(x + 1, y, z) >= kShare) ? 1 : 0;
                crossings += here != (grid.at(x, y + 1, z) >= kShare) ? 1 : 0;
                crossings += here != (grid.at(x, y, z + 1) >= kShare) ? 1 : 0;
            }
        }
    }
    return 2 * crossings;
}

std::vector<mesh::MeshWarning> warnings_of(const Inside& inside, int block) {
    std::vector<mesh::MeshWarning> warnings;
    if (!inside.reason.empty()) {
        warnings.push_back({"volume_inside", 1, "taken as inside: " + inside.reason});
    }
    if (block > 1) {
        warnings.push_back(
            {"volume_coarsened", static_cast<std::size_t>(block),
             "blocks of " + std::to_string(block) + " voxels along each axis averaged"});
    }
    if (inside.not_finite > 0) {
        warnings.push_back({"not_finite_voxels", inside.not_finite,
                            mesh::plural(inside.not_finite, "voxel") + " without a finite value"});
    }
    return warnings;
}

}  // namespace

Result<VolumeSurface> volume_surface(const Volume& volume, const VolumeSurfaceOptions& options,
                                     const std::stop_token& stop) {
    const Error cancelled = {ErrorCode::kCancelled, "reading was cancelled"};
    const Result<Inside> inside = choose_inside(volume, options.inside, stop);
    if (!inside) return inside.error();
    int block = (volume.size.maxCoeff() + options.max_side - 1) / options.max_side;
    while (true) {
        InsideGrid shares(volume, *inside, block);
        if (!shares.fill(stop) || stop.stop_requested()) return cancelled;
        const std::size_t triangles = triangles_of(shares.grid());
        if (triangles > options.max_triangles) {
            ++block;
            continue;
        }
        if (triangles == 0) {
            return {ErrorCode::kSolidEmpty, "expected voxels inside, found none among values of " +
                                                mesh::number_text(inside->least) + " to " +
                                                mesh::number_text(inside->greatest)};
        }
        VolumeSurface surface{level_surface(shares.grid(), kShare, stop),
                              warnings_of(*inside, block)};
        if (stop.stop_requested()) return cancelled;
        return surface;
    }
}

}  // namespace ossuary::voxel
