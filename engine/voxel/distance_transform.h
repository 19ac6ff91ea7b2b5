#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/voxel/bit_volume.h"

namespace ossuary {

/// The exact squared Euclidean distance, in voxels, from each voxel's centre to the centre of the
/// nearest background voxel; 0 on the background. What lies outside the volume is background.
class DistanceField {
public:
    DistanceField() = default;
    DistanceField(const Vec3i& size, std::vector<std::uint32_t> squared)
        : size_(size), squared_(std::move(squared)) {}

    [[nodiscard]] const Vec3i& size() const { return size_; }
    [[nodiscard]] std::size_t index(const Vec3i& v) const {
        return (static_cast<std::size_t>(v.z()) * static_cast<std::size_t>(size_.y()) +
                static_cast<std::size_t>(v.y())) *
                   static_cast<std::size_t>(size_.x()) +
               static_cast<std::size_t>(v.x());
    }
    [[nodiscard]] std::uint32_t squared(const Vec3i& v) const { return squared_[index(v)]; }
    [[nodiscard]] double distance(const Vec3i& v) const {
        return std::sqrt(static_cast<double>(squared(v)));
    }
    [[nodiscard]] const std::vector<std::uint32_t>& values() const { return squared_; }

private:
    Vec3i size_ = Vec3i::Zero();
    std::vector<std::uint32_t> squared_;  ///< x fastest, then y, then z
};

/// Exact, separable, in one pass along each axis; deterministic. Up to 356 voxels a side the
/// columns are searched by vector instructions (distance_scan.h), above that lower envelopes of
/// parabolas are built (distance_envelope.h).
DistanceField distance_transform(const BitVolume& volume);

}  // namespace ossuary
