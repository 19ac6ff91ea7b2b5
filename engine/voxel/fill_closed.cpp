#include "engine/voxel/fill_closed.h"

#include <algorithm>
#include <vector>

#include "engine/voxel/components.h"
#include "engine/voxel/crossing_finder.h"

namespace ossuary::voxel {
namespace {

/// Calls visit(u, v, from, to) for each stretch of a line, in fixed-point depth, inside some part.
template <typename Visit>
void for_each_stretch(std::span<const Crossing> crossings, const SurfaceParts& parts,
                      Visit&& visit) {
    std::vector<std::int32_t> winding(parts.count(), 0);
    for_each_line(crossings, [&](std::span<const Crossing> line) {
        int inside = 0;  // parts around the current place
        std::int32_t entered = 0;
        for (const Crossing& crossing : line) {
            std::int32_t& w = winding[crossing.part];
            const int before = inside;
            inside -= w != 0;
            if (parts.kinds[crossing.part] == SurfaceParts::Kind::kOriented) {
                w += crossing.entering != 0 ? 1 : -1;
            } else {
                w ^= 1;
            }
            inside += w != 0;
            if (before == 0 && inside > 0) entered = crossing.depth;
            if (before > 0 && inside == 0) visit(crossing.u, crossing.v, entered, crossing.depth);
        }
    });
}

Vec3i voxel_at(std::int32_t u, std::int32_t v, std::int32_t depth, int axis, const GridMesh& mesh) {
    Vec3i voxel =
        voxel_on_line(kAxisDirections[static_cast<std::size_t>(axis)], u, v, depth >> kGridBits);
    voxel[axis] = std::clamp(voxel[axis], mesh.low[axis], mesh.high[axis] - 1);
    return voxel;
}

}  // namespace

void fill_inside(std::span<const Crossing> crossings, const SurfaceParts& parts,
                 BitVolume& volume) {
    for_each_stretch(crossings, parts,
                     [&](std::int32_t u, std::int32_t v, std::int32_t from, std::int32_t to) {
                         const std::int32_t begin = first_centre_from(from);
                         const std::int32_t end = first_centre_from(to);
                         if (begin < end) set_run(volume, {begin, end, u, v, 0});
                     });
}

void add_missed(std::span<const Crossing> crossings, const SurfaceParts& parts, int axis,
                const GridMesh& mesh, VoxelSet& voxels) {
    for_each_stretch(crossings, parts,
                     [&](std::int32_t u, std::int32_t v, std::int32_t from, std::int32_t to) {
                         if (first_centre_from(from) < first_centre_from(to)) return;
                         voxels.add(voxel_at(u, v, from + (to - from) / 2, axis, mesh));
                     });
}

void add_crossed(const GridMesh& mesh, std::span<const std::uint32_t> triangles, int axis,
                 const BitVolume& solid, CastMeter& meter, VoxelSet& voxels) {
    const LineDirection& direction = kAxisDirections[static_cast<std::size_t>(axis)];
    CrossingFinder(mesh, direction, meter)
        .find(triangles,
              [&](std::int32_t u, std::int32_t v, std::int32_t depth, std::uint32_t, bool) {
                  const std::int32_t behind = first_centre_from(depth);
                  if (solid.test_or_false(voxel_on_line(direction, u, v, behind)) ||
                      solid.test_or_false(voxel_on_line(direction, u, v, behind - 1))) {
                      return;
                  }
                  voxels.add(voxel_at(u, v, depth, axis, mesh));
              });
}

}  // namespace ossuary::voxel
