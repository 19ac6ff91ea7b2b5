#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::mesh {

/// Numbers positions from 0 in the order in which they first come; equal ones have one number. 0
/// and -0 are equal, and the first to come is kept.
class VertexTable {
public:
    /// @param expected  different positions, so that the table need not grow
    explicit VertexTable(std::size_t expected = 0) {
        slots_.assign(std::bit_ceil(2 * expected + 16), kNone);
        vertices_.reserve(expected);
    }

    std::uint32_t number_of(const Vec3& position) { return number_of(position, hash(position)); }

    /// The same in two steps: between `announce` and it, memory has time to bring what it looks at.
    std::uint64_t announce(const Vec3& position) const {
        const std::uint64_t hashed = hash(position);
        __builtin_prefetch(&slots_[first_slot(hashed)]);
        return hashed;
    }
    std::uint32_t number_of(const Vec3& position, std::uint64_t hashed) {
        if (2 * vertices_.size() >= slots_.size()) grow();
        std::uint32_t& slot = slot_of(position, hashed);
        if (slot == kNone) {
            slot = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back(position);
        }
        return slot;
    }

    [[nodiscard]] const std::vector<Vec3>& vertices() const { return vertices_; }
    [[nodiscard]] std::vector<Vec3> take() && { return std::move(vertices_); }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    static std::uint64_t hash(const Vec3& position) {
        std::uint64_t hashed = 0;
        for (const double x : position) {
            // Adding zero makes -0 and 0 the same bits.
            hashed = (hashed ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15u;
            hashed ^= hashed >> 29;
        }
        return hashed;
    }
    [[nodiscard]] std::size_t first_slot(std::uint64_t hashed) const {
        return (hashed >> 7) & (slots_.size() - 1);
    }

    /// Where the position is, or where it has to go: open addressing.
    std::uint32_t& slot_of(const Vec3& position, std::uint64_t hashed) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = first_slot(hashed);
        while (slots_[at] != kNone && vertices_[slots_[at]] != position) at = (at + 1) & mask;
        return slots_[at];
    }

    void grow() {
        slots_.assign(2 * slots_.size(), kNone);
        for (std::uint32_t v = 0; v < vertices_.size(); ++v)
            slot_of(vertices_[v], hash(vertices_[v])) = v;
    }

    std::vector<Vec3> vertices_;
    std::vector<std::uint32_t> slots_;
};

}  // namespace ossuary::mesh
