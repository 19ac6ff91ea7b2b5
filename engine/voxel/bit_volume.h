#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::voxel {

/// A binary volume, one bit a voxel. Rows run along x; each row starts at a 64-bit word, so bit
/// x % 64 of word x / 64 is voxel x, and the unused high bits of a row's last word are zero.
/// Foreground is 26-connected, background 6-connected, wherever topology is meant.
class BitVolume {
public:
    BitVolume() = default;
    explicit BitVolume(const Vec3i& size)
        : size_(size),
          words_per_row_((static_cast<std::size_t>(size.x()) + 63) / 64),
          words_(words_per_row_ * static_cast<std::size_t>(size.y()) *
                     static_cast<std::size_t>(size.z()),
                 0) {
        assert(size.minCoeff() >= 0);
    }

    [[nodiscard]] const Vec3i& size() const { return size_; }
    [[nodiscard]] std::size_t voxel_count() const {
        return static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
               static_cast<std::size_t>(size_.z());
    }
    [[nodiscard]] std::size_t words_per_row() const { return words_per_row_; }

    [[nodiscard]] bool contains(const Vec3i& v) const {
        return (v.array() >= 0).all() && (v.array() < size_.array()).all();
    }
    /// @pre contains({x, y, z})
    [[nodiscard]] bool test(int x, int y, int z) const {
        return (words_[word_index(x, y, z)] >> (static_cast<unsigned>(x) & 63u)) & 1u;
    }
    [[nodiscard]] bool test(const Vec3i& v) const { return test(v.x(), v.y(), v.z()); }
    /// Like test, but false outside the volume.
    [[nodiscard]] bool test_or_false(const Vec3i& v) const { return contains(v) && test(v); }

    void set(int x, int y, int z) { words_[word_index(x, y, z)] |= bit(x); }
    void set(const Vec3i& v) { set(v.x(), v.y(), v.z()); }
    void reset(int x, int y, int z) { words_[word_index(x, y, z)] &= ~bit(x); }
    void reset(const Vec3i& v) { reset(v.x(), v.y(), v.z()); }

    [[nodiscard]] std::span<std::uint64_t> row(int y, int z) {
        return {words_.data() + row_index(y, z), words_per_row_};
    }
    [[nodiscard]] std::span<const std::uint64_t> row(int y, int z) const {
        return {words_.data() + row_index(y, z), words_per_row_};
    }
    [[nodiscard]] std::span<const std::uint64_t> words() const { return words_; }
    [[nodiscard]] std::span<std::uint64_t> words() { return words_; }

    /// Number of set voxels.
    [[nodiscard]] std::size_t count() const {
        std::size_t total = 0;
        for (const std::uint64_t word : words_) {
            total += static_cast<std::size_t>(std::popcount(word));
        }
        return total;
    }

    /// Whether no voxel is set.
    [[nodiscard]] bool empty() const {
        for (const std::uint64_t word : words_) {
            if (word != 0) return false;
        }
        return true;
    }

    bool operator==(const BitVolume&) const = default;

private:
    [[nodiscard]] std::size_t row_index(int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y()) +
                static_cast<std::size_t>(y)) *
               words_per_row_;
    }
    [[nodiscard]] std::size_t word_index(int x, int y, int z) const {
        assert(contains({x, y, z}));
        return row_index(y, z) + (static_cast<std::size_t>(x) >> 6);
    }
    static std::uint64_t bit(int x) { return std::uint64_t{1} << (static_cast<unsigned>(x) & 63u); }

    Vec3i size_ = Vec3i::Zero();
    std::size_t words_per_row_ = 0;
    std::vector<std::uint64_t> words_;
};

/// Calls `visit(Vec3i)` for every set voxel, x fastest, then y, then z.
template <typename Visit>
void for_each_voxel(const BitVolume& volume, Visit&& visit) {
    for (int z = 0; z < volume.size().z(); ++z) {
        for (int y = 0; y < volume.size().y(); ++y) {
            const auto row = volume.row(y, z);
            for (std::size_t w = 0; w < row.size(); ++w) {
                for (std::uint64_t word = row[w]; word != 0; word &= word - 1) {
                    visit(Vec3i(static_cast<int>(w * 64) + std::countr_zero(word), y, z));
                }
            }
        }
    }
}

/// Calls `visit(begin, end)` for every maximal run [begin, end) of set bits in a row of `size`
/// bits, or of clear bits when `complement`.
template <typename Visit>
void for_each_run(std::span<const std::uint64_t> row, int size, bool complement, Visit&& visit) {
    const std::uint64_t flip = complement ? ~std::uint64_t{0} : 0;
    int begin = -1;
    for (std::size_t w = 0; w < row.size(); ++w) {
        const int base = static_cast<int>(w * 64);
        std::uint64_t word = row[w] ^ flip;
        if (base + 64 > size) word &= (std::uint64_t{1} << (size - base)) - 1;
        for (int x = 0; x < 64;) {
            const std::uint64_t rest = (begin < 0 ? word : ~word) >> x;
            if (rest == 0) break;
            x += std::countr_zero(rest);
            if (begin < 0) {
                begin = base + x;
            } else {
                visit(begin, base + x);
                begin = -1;
            }
        }
    }
    if (begin >= 0) visit(begin, size);
}

}  // namespace ossuary::voxel
