#include "engine/voxel/voxelize.h"

#include <string>
#include <utility>
#include <vector>

#include "engine/voxel/components.h"
#include "engine/voxel/fill_closed.h"
#include "engine/voxel/fill_open.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/ray_columns.h"
#include "engine/voxel/solid_components.h"
#include "engine/voxel/surface_parts.h"
#include "engine/voxel/thin_parts.h"

namespace ossuary {
namespace {

void warn(VoxelSolid& solid, const char* code, std::size_t count, const std::string& message) {
    if (count > 0) solid.warnings.push_back({code, count, std::to_string(count) + message});
}

/// Everything that lies inside or on the surface.
void fill(const GridMesh& mesh, const SurfaceParts& parts, VoxelSolid& solid) {
    std::vector<std::uint32_t> closed, open;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool is_open = parts.kinds[parts.part_of[t]] == SurfaceParts::Kind::kOpen;
        (is_open ? open : closed).push_back(t);
    }
    BitVolume thin(mesh.size);
    for (int axis = 0; axis < 3; ++axis) {
        const LineDirection& direction = kAxisDirections[static_cast<std::size_t>(axis)];
        const auto crossings = cast_lines(mesh, closed, parts.part_of, direction);
        if (axis == 0) fill_inside(crossings, parts, solid.volume);
        mark_missed(crossings, parts, axis, mesh, thin);
        if (!open.empty()) {
            mark_crossed(cast_lines(mesh, open, parts.part_of, direction), axis, mesh, thin);
        }
    }
    if (!open.empty()) fill_open_parts(mesh, parts, solid.volume);
    const bool encloses = solid.volume.count() > 0;
    solid.method = !encloses      ? "surface"
                   : open.empty() ? "winding"
                                  : (closed.empty() ? "voting" : "winding+voting");
    const std::size_t added = add_thin_parts(mesh, thin, solid.volume);
    warn(solid, "open_surface", parts.open_triangles, " triangles belong to parts with a border");
    warn(solid, "repeated_triangles", mesh.repeated_triangles, " triangles come more than once");
    warn(solid, "thin_parts", added, " voxels keep parts thinner than a voxel");
}

}  // namespace

Result<VoxelSolid> voxelize(const TriangleMesh& mesh, const VoxelizeOptions& options) {
    if (options.bridge_gap < 0 || options.bridge_gap > 4) {
        return {ErrorCode::kInvalidArgument,
                "bridge_gap: found " + std::to_string(options.bridge_gap) + ", expected 0 to 4"};
    }
    auto grid = lay_into_grid(mesh, options);
    if (!grid) return grid.error();
    const SurfaceParts parts = find_parts(*grid);

    VoxelSolid solid;
    solid.volume = BitVolume(grid->size);
    solid.world_from_grid = grid->world_from_grid;
    fill(*grid, parts, solid);

    if (options.fill_cavities) {
        const FilledCavities filled = fill_cavities(solid.volume);
        warn(solid, "filled_cavities", filled.cavities,
             " cavities filled, of " + std::to_string(filled.voxels) + " voxels");
    }
    const JoinedComponents joined =
        join_components(solid.volume, {options.bridge_gap, options.min_component_extent});
    warn(solid, "bridged_components", joined.bridged, " gaps between components bridged");
    warn(solid, "dropped_components", joined.dropped,
         " small components dropped, of " + std::to_string(joined.dropped_voxels) + " voxels");
    warn(solid, "several_components", joined.remaining > 1 ? joined.remaining : 0,
         " separate components remain");
    if (solid.volume.count() == 0) {
        return {ErrorCode::kSolidEmpty, "no voxel is inside or on the surface"};
    }
    return solid;
}

}  // namespace ossuary
