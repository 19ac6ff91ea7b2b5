#include "engine/voxel/fill_open.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "engine/voxel/ray_columns.h"

namespace ossuary {
namespace {

/// For each voxel of a box, how many lines say inside and how many are silent.
class Ballot {
public:
    Ballot(const Vec3i& low, const Vec3i& high)
        : low_(low),
          size_(high - low),
          inside_(voxel_count(), 0),
          silent_(voxel_count(), 0),
          blocked_(voxel_count(), 0),
          verdict_(voxel_count(), 0) {}

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

    /// Sets the voxels that are inside.
    void count(BitVolume& volume) {
        decide();
        spread();
        for (std::size_t i = 0; i < verdict_.size(); ++i) {
            if (verdict_[i] == kInside) volume.set(low_ + voxel(i));
        }
    }

    /// Between voxels k - 1 and k along an axis there is a surface.
    void block(int axis, Vec3i v) {
        v -= low_;
        if ((v.array() >= 0).all() && (v.array() < size_.array()).all()) {
            blocked_[index(v)] |= static_cast<std::uint8_t>(1 << axis);
        }
    }

private:
    enum Verdict : std::uint8_t { kUndecided, kInside, kOutside };
    static int kMargin;

    void decide() {
        constexpr int kLines = static_cast<int>(kThirteenDirections.size());
        for (std::size_t i = 0; i < verdict_.size(); ++i) {
            const int lead = 2 * inside_[i] + silent_[i] - kLines;  // inside less outside
            if (lead >= kMargin) verdict_[i] = kInside;
            if (lead <= -kMargin) verdict_[i] = kOutside;
        }
    }

    /// The undecided take the verdict of the nearest decided voxel that no surface hides, by steps
    /// through faces; where both arrive at once, outside.
    void spread() {
        std::vector<std::uint32_t> front, next;
        for (std::size_t i = 0; i < verdict_.size(); ++i) {
            if (verdict_[i] != kUndecided) front.push_back(static_cast<std::uint32_t>(i));
        }
        const std::ptrdiff_t stride[3] = {1, size_.x(),
                                          static_cast<std::ptrdiff_t>(size_.x()) * size_.y()};
        std::vector<std::uint8_t> pending(verdict_.size(), kUndecided);
        while (!front.empty()) {
            next.clear();
            for (const std::uint32_t i : front) {
                const Vec3i v = voxel(i);
                for (int axis = 0; axis < 3; ++axis) {
                    for (const int sign : {-1, 1}) {
                        const int k = v[axis] + sign;
                        if (k < 0 || k >= size_[axis]) continue;
                        const auto j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) +
                                                                sign * stride[axis]);
                        if (verdict_[j] != kUndecided) continue;
                        if ((blocked_[sign > 0 ? j : i] >> axis & 1) != 0) continue;
                        if (pending[j] == kUndecided) next.push_back(static_cast<std::uint32_t>(j));
                        pending[j] = std::max(pending[j], verdict_[i]);
                    }
                }
            }
            for (const std::uint32_t j : next) verdict_[j] = pending[j];
            std::swap(front, next);
        }
    }

    [[nodiscard]] Vec3i voxel(std::size_t i) const {
        const int n = static_cast<int>(i);
        return {n % size_.x(), n / size_.x() % size_.y(), n / size_.x() / size_.y()};
    }
    [[nodiscard]] std::size_t index(const Vec3i& v) const {
        return static_cast<std::size_t>(v.x() + size_.x() * (v.y() + size_.y() * v.z()));
    }

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
    std::vector<std::uint8_t> inside_, silent_, blocked_, verdict_;
};

int Ballot::kMargin = getenv("M") ? atoi(getenv("M")) : 1;
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
