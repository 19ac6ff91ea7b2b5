#include "engine/voxel/ballot.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ossuary::voxel {

Ballot::Ballot(const Vec3i& low, const Vec3i& high)
    : low_(low),
      size_(high - low),
      inside_(voxel_count(), 0),
      silent_(voxel_count(), 0),
      blocked_(voxel_count(), 0),
      verdict_(voxel_count(), kUndecided) {}

void Ballot::cast(const LineDirection& direction, std::int32_t u, std::int32_t v,
                  std::span<const std::int32_t> depths) {
    const std::int32_t first = low_[direction.axis];
    const std::int32_t end = first + size_[direction.axis];
    if (depths.size() % 2 != 0) {
        add(silent_, direction, u, v, first, end);
        return;
    }
    for (std::size_t i = 0; i < depths.size(); i += 2) {
        add(inside_, direction, u, v, std::max(first, first_centre_from(depths[i])),
            std::min(end, first_centre_from(depths[i + 1])));
    }
}

void Ballot::block(int axis, const Vec3i& voxel) {
    const Vec3i v = voxel - low_;
    if ((v.array() >= 0).all() && (v.array() < size_.array()).all()) {
        blocked_[index(v)] |= static_cast<std::uint8_t>(1 << axis);
    }
}

void Ballot::count(BitVolume& volume) {
    decide();
    spread();
    for (std::size_t i = 0; i < verdict_.size(); ++i) {
        if (verdict_[i] == kInside) volume.set(low_ + voxel(i));
    }
}

/// One vote more for the voxels number begin to end - 1 of a line, as far as they are in the box.
void Ballot::add(std::vector<std::uint8_t>& votes, const LineDirection& direction, std::int32_t u,
                 std::int32_t v, std::int32_t begin, std::int32_t end) const {
    if (begin >= end) return;
    const std::ptrdiff_t stride[3] = {1, size_.x(),
                                      static_cast<std::ptrdiff_t>(size_.x()) * size_.y()};
    const int axes[3] = {direction.axis, (direction.axis + 1) % 3, (direction.axis + 2) % 3};
    const int steps[3] = {1, direction.shear[0], direction.shear[1]};
    const Vec3i at = voxel_on_line(direction, u, v, begin) - low_;
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
    std::ptrdiff_t place = 0, step = 0;
    for (int i = 0; i < 3; ++i) {
        place += (at[axes[i]] + skip * steps[i]) * stride[axes[i]];
        step += steps[i] * stride[axes[i]];
    }
    for (std::int32_t k = skip; k < length; ++k, place += step) {
        ++votes[static_cast<std::size_t>(place)];
    }
}

void Ballot::decide() {
    constexpr int kLines = static_cast<int>(kThirteenDirections.size());
    for (std::size_t i = 0; i < verdict_.size(); ++i) {
        const int lead = 2 * inside_[i] + silent_[i] - kLines;  // inside less outside
        if (lead > 0) verdict_[i] = kInside;
        if (lead < 0) verdict_[i] = kOutside;
    }
}

/// Calls visit(index) for the face neighbours with no surface in between.
template <typename Visit>
void Ballot::for_each_open_neighbor(std::size_t i, Visit&& visit) const {
    const Vec3i v = voxel(i);
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (v[axis] > 0 && (blocked_[i] >> axis & 1) == 0) visit(i - stride);
        if (v[axis] + 1 < size_[axis] && (blocked_[i + stride] >> axis & 1) == 0) {
            visit(i + stride);
        }
        stride *= static_cast<std::size_t>(size_[axis]);
    }
}

void Ballot::spread() {
    std::vector<std::pair<std::size_t, std::uint8_t>> decided, next;
    for (std::size_t i = 0; i < verdict_.size(); ++i) {
        if (verdict_[i] != kUndecided) continue;
        std::uint8_t verdict = kUndecided;
        for_each_open_neighbor(i, [&](std::size_t j) { verdict = std::max(verdict, verdict_[j]); });
        if (verdict != kUndecided) decided.emplace_back(i, verdict);
    }
    while (!decided.empty()) {
        // Only now, so that all of one distance are decided at once. kOutside is the larger value.
        for (const auto& [i, verdict] : decided) verdict_[i] = std::max(verdict_[i], verdict);
        next.clear();
        for (const auto& [i, ignored] : decided) {
            for_each_open_neighbor(i, [&, from = i](std::size_t j) {
                if (verdict_[j] == kUndecided) next.emplace_back(j, verdict_[from]);
            });
        }
        std::swap(decided, next);
    }
}

std::size_t Ballot::voxel_count() const {
    return static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
           static_cast<std::size_t>(size_.z());
}

std::size_t Ballot::index(const Vec3i& v) const {
    return (static_cast<std::size_t>(v.z()) * static_cast<std::size_t>(size_.y()) +
            static_cast<std::size_t>(v.y())) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(v.x());
}

Vec3i Ballot::voxel(std::size_t i) const {
    const auto nx = static_cast<std::size_t>(size_.x());
    const auto ny = static_cast<std::size_t>(size_.y());
    return {static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / nx / ny)};
}

}  // namespace ossuary::voxel
