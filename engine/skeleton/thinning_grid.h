#pragma once

#include <bit>
#include <cstring>

#include "engine/skeleton/neighborhood.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::skeleton {

/// Index of a voxel in the padded bit grid that thinning works on.
using VoxelIndex = std::uint32_t;

/// The shape of a volume with one empty layer around it, in rows of whole bytes, so that a 3x3x3
/// neighbourhood is nine loads with one common shift and no test for the border.
class PaddedShape {
public:
    PaddedShape() = default;
    explicit PaddedShape(const Vec3i& size)
        : size_(size),
          row_((static_cast<std::uint32_t>(size.x()) + 2 + 7) / 8 * 8),
          plane_(row_ * (static_cast<std::uint32_t>(size.y()) + 2)) {}

    /// Of the volume without its padding.
    [[nodiscard]] const Vec3i& size() const { return size_; }
    [[nodiscard]] std::uint32_t row() const { return row_; }
    [[nodiscard]] std::uint32_t plane() const { return plane_; }
    /// Number of indices.
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(plane_) * (static_cast<std::size_t>(size_.z()) + 2);
    }
    [[nodiscard]] VoxelIndex index(int x, int y, int z) const {
        return (static_cast<std::uint32_t>(z) + 1) * plane_ +
               (static_cast<std::uint32_t>(y) + 1) * row_ + static_cast<std::uint32_t>(x) + 1;
    }
    [[nodiscard]] VoxelIndex index(const Vec3i& v) const { return index(v.x(), v.y(), v.z()); }
    [[nodiscard]] Vec3i position(VoxelIndex index) const {
        const std::uint32_t in_plane = index % plane_;
        return {static_cast<int>(in_plane % row_) - 1, static_cast<int>(in_plane / row_) - 1,
                static_cast<int>(index / plane_) - 1};
    }
    /// What to add to an index to reach each neighbour.
    [[nodiscard]] std::array<std::int32_t, 27> neighbor_steps() const {
        std::array<std::int32_t, 27> steps{};
        for (int bit = 0; bit < 27; ++bit) {
            const NeighborOffset o = neighbor_offset(bit);
            steps[static_cast<std::size_t>(bit)] = o.dz * static_cast<std::int32_t>(plane_) +
                                                   o.dy * static_cast<std::int32_t>(row_) + o.dx;
        }
        return steps;
    }

private:
    Vec3i size_ = Vec3i::Zero();
    std::uint32_t row_ = 0;
    std::uint32_t plane_ = 0;
};

constexpr VoxelIndex moved(VoxelIndex index, std::int32_t step) {
    return index + static_cast<std::uint32_t>(step);
}

/// A set of voxels as bits in a padded shape.
class ThinningGrid {
public:
    explicit ThinningGrid(const PaddedShape& shape)
        : shape_(shape), row_bytes_(shape.row() / 8), plane_bytes_(shape.plane() / 8) {
        static_assert(std::endian::native == std::endian::little);
        bytes_.resize(shape.count() / 8 + 8, 0);
    }
    explicit ThinningGrid(const voxel::BitVolume& volume)
        : ThinningGrid(PaddedShape(volume.size())) {
        for (int z = 0; z < volume.size().z(); ++z) {
            for (int y = 0; y < volume.size().y(); ++y) copy_row(volume.row(y, z), y, z);
        }
    }

    [[nodiscard]] const PaddedShape& shape() const { return shape_; }
    [[nodiscard]] bool test(VoxelIndex v) const { return bytes_[v >> 3] >> (v & 7u) & 1u; }
    void set(VoxelIndex v) {
        bytes_[v >> 3] = static_cast<std::uint8_t>(bytes_[v >> 3] | 1u << (v & 7u));
    }
    void reset(VoxelIndex v) {
        bytes_[v >> 3] = static_cast<std::uint8_t>(bytes_[v >> 3] & ~(1u << (v & 7u)));
    }

    void flip(VoxelIndex v) {
        bytes_[v >> 3] = static_cast<std::uint8_t>(bytes_[v >> 3] ^ 1u << (v & 7u));
    }

    /// @pre `v` is not in the padding
    [[nodiscard]] Neighborhood neighborhood(VoxelIndex v) const {
        const std::uint32_t first = v - 1;
        const std::uint8_t* centre = bytes_.data() + (first >> 3);
        const std::uint32_t shift = first & 7u;
        const Neighborhood low = plane_at(centre - plane_bytes_, shift);
        const Neighborhood middle = plane_at(centre, shift);
        const Neighborhood high = plane_at(centre + plane_bytes_, shift);
        return low | middle << 9 | high << 18;
    }

    /// The neighbourhood without edge and corner neighbours and the centre.
    [[nodiscard]] Neighborhood face_neighbors(VoxelIndex v) const {
        const std::uint32_t first = v - 1;
        const std::uint8_t* centre = bytes_.data() + (first >> 3);
        const std::uint32_t shift = first & 7u;
        return (row_at(centre - plane_bytes_, shift) & 2u) << 3 |
               (row_at(centre - row_bytes_, shift) & 2u) << 9 | (row_at(centre, shift) & 5u) << 12 |
               (row_at(centre + row_bytes_, shift) & 2u) << 15 |
               (row_at(centre + plane_bytes_, shift) & 2u) << 21;
    }

    /// Without the padding.
    [[nodiscard]] voxel::BitVolume volume() const {
        voxel::BitVolume result(shape_.size());
        for_each([&](VoxelIndex v) { result.set(shape_.position(v)); });
        return result;
    }

    /// Calls `visit(VoxelIndex)` for every voxel of the set in increasing order.
    template <typename Visit>
    void for_each(Visit&& visit) const {
        const std::size_t words = bytes_.size() / 8;
        for (std::size_t w = 0; w < words; ++w) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes_.data() + w * 8, 8);
            for (; word != 0; word &= word - 1) {
                visit(static_cast<VoxelIndex>(w * 64) +
                      static_cast<VoxelIndex>(std::countr_zero(word)));
            }
        }
    }

private:
    [[nodiscard]] Neighborhood plane_at(const std::uint8_t* centre, std::uint32_t shift) const {
        return row_at(centre - row_bytes_, shift) | row_at(centre, shift) << 3 |
               row_at(centre + row_bytes_, shift) << 6;
    }
    static Neighborhood row_at(const std::uint8_t* bytes, std::uint32_t shift) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, bytes, 2);
        return static_cast<Neighborhood>(bits) >> shift & 7u;
    }
    void copy_row(std::span<const std::uint64_t> row, int y, int z) {
        // One bit further along for the padding: rows start at whole bytes, not whole words.
        std::uint8_t* out = bytes_.data() + (shape_.index(-1, y, z) >> 3);
        std::uint64_t carry = 0;
        std::size_t left = row_bytes_;
        for (const std::uint64_t word : row) {
            const std::uint64_t shifted = word << 1 | carry;
            carry = word >> 63;
            const std::size_t bytes = left < 8 ? left : 8;
            std::memcpy(out, &shifted, bytes);
            out += bytes;
            left -= bytes;
        }
        if (left > 0) std::memcpy(out, &carry, left < 8 ? left : 8);
    }

    PaddedShape shape_;
    std::size_t row_bytes_ = 0;
    std::size_t plane_bytes_ = 0;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace ossuary::skeleton
