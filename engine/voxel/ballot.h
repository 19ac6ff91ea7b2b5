#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/ray_columns.h"

namespace ossuary::voxel {

/// For each voxel of a box, how many of the thirteen lines through it say inside, how many outside
/// and how many are silent.
class Ballot {
public:
    /// Of the voxels in [low, high).
    Ballot(const Vec3i& low, const Vec3i& high);

    /// Takes the vote of the line (u, v) by the depths of all its crossings, in order: by parity if
    /// they are even in number; else the line has passed through a hole and is silent. Lines
    /// without crossings say outside.
    void cast(const LineDirection& direction, std::int32_t u, std::int32_t v,
              std::span<const std::int32_t> depths);

    /// Notes that there is a surface between the voxel and the one before it along an axis.
    void block(int axis, const Vec3i& voxel);

    /// Sets the voxels that are inside: by majority, and where nobody has a majority, as in the
    /// mouth of an opening, like the nearest voxels with one that no surface hides (by steps
    /// through faces; where inside and outside arrive at once, outside).
    void count(BitVolume& volume);

private:
    enum Verdict : std::uint8_t { kUndecided, kInside, kOutside };

    void add(std::vector<std::uint8_t>& votes, const LineDirection& direction, std::int32_t u,
             std::int32_t v, std::int32_t begin, std::int32_t end) const;
    void decide();
    void spread();
    template <typename Visit>
    void for_each_open_neighbor(std::size_t i, Visit&& visit) const;

    [[nodiscard]] std::size_t voxel_count() const;
    [[nodiscard]] std::size_t index(const Vec3i& v) const;
    [[nodiscard]] Vec3i voxel(std::size_t i) const;

    Vec3i low_, size_;
    std::vector<std::uint8_t> inside_, silent_;  ///< numbers of lines
    std::vector<std::uint8_t> blocked_;          ///< bit `axis`: surface towards the voxel before
    std::vector<std::uint8_t> verdict_;
};

}  // namespace ossuary::voxel
