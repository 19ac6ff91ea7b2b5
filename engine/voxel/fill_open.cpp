#include "engine/voxel/fill_open.h"

#include <algorithm>
#include <vector>

#include "engine/voxel/ray_columns.h"

namespace ossuary {
namespace {

/// For each voxel of a box, how many lines say inside and how many are silent.
class Ballot {
public:
    Ballot(const Vec3i& low, const Vec3i& high)
        : low_(low), size_(high - low), inside_(voxel_count(), 0), silent_(voxel_count(), 0) {}

    /// Takes the vote of one line with its crossings.
    void cast(const LineDirection& direction, std::span<const Crossing> line) {
        const std::int32_t first = low_[direction.axis];
        const std::int32_t end = first + size_[direction.axis];
        const std::int32_t u = line[0].u;
        const std::int32_t v = line[0].v;
        if (line.size() % 2 != 0) {
            add(silent_, direction, u, v, first, end);
            return;
        }
        for (std::size_t i = 0; i < line.size(); i += 2) {
            add(inside_, direction, u, v, std::max(first, first_centre_from(line[i].depth)),
                std::min(end, first_centre_from(line[i + 1].depth)));
        }
    }

    /// Sets the voxels that a majority of the lines finds inside.
    void count(BitVolume& volume) const {
        std::size_t i = 0;
        for (int z = 0; z < size_.z(); ++z) {
            for (int y = 0; y < size_.y(); ++y) {
                for (int x = 0; x < size_.x(); ++x, ++i) {
                    constexpr int kLines = static_cast<int>(kThirteenDirections.size());
                    const int outside = kLines - inside_[i] - silent_[i];
                    if (inside_[i] >= kMinVotes && inside_[i] > outside) {
                        volume.set(low_ + Vec3i(x, y, z));
                    }
                }
            }
        }
    }

private:
    static constexpr int kMinVotes = 2;

    [[nodiscard]] std::size_t voxel_count() const {
        return static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
               static_cast<std::size_t>(size_.z());
    }

    void add(std::vector<std::uint8_t>& votes, const LineDirection& direction, std::int32_t u,
             std::int32_t v, std::int32_t begin, std::int32_t end) {
        if (begin >= end) return;
        const std::ptrdiff_t stride[3] = {1, size_.x(),
                                          static_cast<std::ptrdiff_t>(size_.x()) * size_.y()};
        const int axes[3] = {direction.axis, (direction.axis + 1) % 3, (direction.axis + 2) % 3};
        const int steps[3] = {1, direction.shear[0], direction.shear[1]};
        // The stretch of the line within the box.
        Vec3i at = voxel_on_line(direction, u, v, begin) - low_;
        std::int32_t skip = 0;
        std::int32_t length = end - begin;
        for (int i = 1; i < 3; ++i) {
            const std::int32_t p = at[axes[i]];
            const std::int32_t side = size_[axes[i]];
            if (steps[i] == 0) {
                if (p < 0 || p >= side) return;
            } else if (steps[i] > 0) {
                skip = std::max(skip, -p);
                length = std::min(length, side - p);
            } else {
                skip = std::max(skip, p - side + 1);
                length = std::min(length, p + 1);
            }
        }
        if (skip >= length) return;
        std::ptrdiff_t index = 0, step = 0;
        for (int i = 0; i < 3; ++i) {
            index += (at[axes[i]] + skip * steps[i]) * stride[axes[i]];
            step += steps[i] * stride[axes[i]];
        }
        for (std::int32_t k = skip; k < length; ++k, index += step) {
            ++votes[static_cast<std::size_t>(index)];
        }
    }

    Vec3i low_, size_;
    std::vector<std::uint8_t> inside_, silent_;
};

void vote(const GridMesh& mesh, const std::vector<std::uint32_t>& triangles,
          const SurfaceParts& parts, BitVolume& volume) {
    Vec3i low = mesh.high, high = mesh.low;
    for (const std::uint32_t t : triangles) {
        for (const std::uint32_t p : mesh.triangles[t]) {
            const Vec3i voxel = mesh.voxel_of(mesh.points[p]);
            low = low.cwiseMin(voxel);
            high = high.cwiseMax(voxel + Vec3i::Ones());
        }
    }
    Ballot ballot(low, high);
    for (const LineDirection& direction : kThirteenDirections) {
        const auto crossings = cast_lines(mesh, triangles, parts.part_of, direction);
        for_each_line(crossings,
                      [&](std::span<const Crossing> line) { ballot.cast(direction, line); });
    }
    ballot.count(volume);
}

}  // namespace

void fill_open_parts(const GridMesh& mesh, const SurfaceParts& parts, BitVolume& volume) {
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
        if (triangles.size() >= 3) vote(mesh, triangles, parts, volume);
    }
    if (open_parts > 1) vote(mesh, all, parts, volume);
}

}  // namespace ossuary
