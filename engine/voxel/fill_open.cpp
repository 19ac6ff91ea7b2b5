#include "engine/voxel/fill_open.h"

#include <algorithm>
#include <vector>

#include "engine/voxel/ballot.h"
#include "engine/voxel/line_depths.h"
#include "engine/voxel/ray_columns.h"

namespace ossuary::voxel {
namespace {

/// Larger boxes are voted on slab by slab, so that memory stays within some hundred megabytes.
constexpr std::int64_t kMaxBallotVoxels = std::int64_t{1} << 25;

/// Setting up the lines of a part, however small, takes as long as some thousand rows.
constexpr std::uint64_t kStepsOfPart = 2000;

/// Hands the votes of one family of lines in.
void cast(const LineDepths& lines, const LineDirection& direction, Ballot& ballot) {
    const bool along_axis = direction.shear[0] == 0 && direction.shear[1] == 0;
    lines.for_each_line([&](std::int32_t u, std::int32_t v, std::span<const std::int32_t> depths) {
        ballot.cast(direction, u, v, depths);
        for (const std::int32_t depth : depths) {
            if (!along_axis) break;
            const std::int32_t k = first_centre_from(depth);
            ballot.block(direction.axis, voxel_on_line(direction, u, v, k));
        }
    });
}

void vote(const GridMesh& mesh, const std::vector<std::uint32_t>& triangles, CastMeter& meter,
          BitVolume& volume) {
    if (!meter.count_steps(kStepsOfPart)) return;
    Vec3i low = mesh.high, high = mesh.low;
    for (const std::uint32_t t : triangles) {
        for (const std::uint32_t p : mesh.triangles[t]) {
            const Vec3i voxel = mesh.voxel_of(mesh.points[p]);
            low = low.cwiseMin(voxel);
            high = high.cwiseMax(voxel + Vec3i::Ones());
        }
    }
    const std::int64_t slice = std::int64_t{high.x() - low.x()} * (high.y() - low.y());
    const int slab = static_cast<int>(std::max<std::int64_t>(kMaxBallotVoxels / slice, 1));
    // The depths of all directions at once are in memory only where several ballots need them.
    std::vector<LineDepths> kept;
    for (int z = low.z(); z < high.z(); z += slab) {
        const int end = std::min(z + slab, high.z());
        Ballot ballot({low.x(), low.y(), z}, {high.x(), high.y(), end});
        for (std::size_t i = 0; i < kThirteenDirections.size(); ++i) {
            const LineDirection& direction = kThirteenDirections[i];
            if (i < kept.size()) {
                cast(kept[i], direction, ballot);
                continue;
            }
            LineDepths lines(mesh, triangles, direction, meter);
            if (meter.over()) return;
            cast(lines, direction, ballot);
            if (end < high.z()) kept.push_back(std::move(lines));
        }
        ballot.count(volume);
    }
}

}  // namespace

// Overlap with the exact solid, 18 closed models of the segmentation benchmark, turned, at 64
// voxels: .999 without 2 % of the triangles, .997 without 10 %, .954 without 30 %, .996 and .979
// with a hole of a twentieth and a tenth of the model's size across. A box without its lid: .97 and
// more in every pose, .86 where undecided voxels stay empty. Gaps closed by flooding the outside
// after growing the surface by up to four voxels changed 1 in 151 models of the shape benchmark.
void fill_open_parts(const GridMesh& mesh, const SurfaceParts& parts, CastMeter& meter,
                     BitVolume& volume) {
    std::vector<std::vector<std::uint32_t>> of_part(parts.count());
    std::vector<std::uint32_t> all;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (parts.kinds[parts.part_of[t]] != SurfaceParts::Kind::kOpen) continue;
        of_part[parts.part_of[t]].push_back(t);
        all.push_back(t);
    }
    std::size_t open_parts = 0;
    for (const auto& triangles : of_part) {
        if (triangles.empty()) continue;
        ++open_parts;
        // Fewer than three triangles enclose nothing from more than one side.
        if (triangles.size() >= 3) vote(mesh, triangles, meter, volume);
        if (meter.over()) return;
    }
    if (open_parts > 1) vote(mesh, all, meter, volume);
}

}  // namespace ossuary::voxel
