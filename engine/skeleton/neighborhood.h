#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace ossuary::skeleton {

/// The 3x3x3 neighbourhood of a voxel as 27 bits: bit (dz+1)*9 + (dy+1)*3 + (dx+1) is the voxel at
/// offset (dx, dy, dz); bit 13 is the voxel itself.
using Neighborhood = std::uint32_t;

inline constexpr int kCentreBit = 13;
inline constexpr Neighborhood kWholeNeighborhood = (Neighborhood{1} << 27) - 1;
inline constexpr Neighborhood kCentre = Neighborhood{1} << kCentreBit;

struct NeighborOffset {
    int dx = 0;
    int dy = 0;
    int dz = 0;
    /// How many coordinates differ: 1 for face, 2 for edge, 3 for corner neighbours, 0 for itself.
    [[nodiscard]] constexpr int order() const { return dx * dx + dy * dy + dz * dz; }
    bool operator==(const NeighborOffset&) const = default;
};

constexpr NeighborOffset neighbor_offset(int bit) {
    return {bit % 3 - 1, bit / 3 % 3 - 1, bit / 9 - 1};
}

constexpr int neighbor_bit(const NeighborOffset& o) {
    return (o.dz + 1) * 9 + (o.dy + 1) * 3 + o.dx + 1;
}

/// The voxel on the other side of the centre.
constexpr int opposite_bit(int bit) { return 26 - bit; }

namespace detail {
constexpr Neighborhood neighbors_of_order(int order) {
    Neighborhood mask = 0;
    for (int bit = 0; bit < 27; ++bit) {
        if (neighbor_offset(bit).order() == order) mask |= Neighborhood{1} << bit;
    }
    return mask;
}
constexpr Neighborhood without_coordinate(int axis, int value) {
    Neighborhood mask = 0;
    for (int bit = 0; bit < 27; ++bit) {
        const NeighborOffset o = neighbor_offset(bit);
        const int coordinate = axis == 0 ? o.dx : axis == 1 ? o.dy : o.dz;
        if (coordinate != value) mask |= Neighborhood{1} << bit;
    }
    return mask;
}
inline constexpr Neighborhood kNotLowX = without_coordinate(0, -1);
inline constexpr Neighborhood kNotHighX = without_coordinate(0, 1);
inline constexpr Neighborhood kNotLowY = without_coordinate(1, -1);
inline constexpr Neighborhood kNotHighY = without_coordinate(1, 1);
}  // namespace detail

inline constexpr Neighborhood kFaceNeighbors = detail::neighbors_of_order(1);
inline constexpr Neighborhood kEdgeNeighbors = detail::neighbors_of_order(2);
inline constexpr Neighborhood kCornerNeighbors = detail::neighbors_of_order(3);
inline constexpr Neighborhood k18Neighbors = kFaceNeighbors | kEdgeNeighbors;
inline constexpr Neighborhood k26Neighbors = k18Neighbors | kCornerNeighbors;

/// The voxels of the neighbourhood that are in `set` or 26-adjacent to one in it.
constexpr Neighborhood dilate_26(Neighborhood set) {
    set |= ((set & detail::kNotHighX) << 1) | ((set & detail::kNotLowX) >> 1);
    set |= ((set & detail::kNotHighY) << 3) | ((set & detail::kNotLowY) >> 3);
    set |= (set << 9) | (set >> 9);
    return set & kWholeNeighborhood;
}

/// The voxels of the neighbourhood that are in `set` or 6-adjacent to one in it.
constexpr Neighborhood dilate_6(Neighborhood set) {
    return (set | ((set & detail::kNotHighX) << 1) | ((set & detail::kNotLowX) >> 1) |
            ((set & detail::kNotHighY) << 3) | ((set & detail::kNotLowY) >> 3) | (set << 9) |
            (set >> 9)) &
           kWholeNeighborhood;
}

/// Euclidean length of the step to each neighbour.
inline constexpr std::array<float, 27> kNeighborLength = [] {
    constexpr std::array<float, 4> by_order = {0.0f, 1.0f, 1.41421356f, 1.73205081f};
    std::array<float, 27> length{};
    for (int bit = 0; bit < 27; ++bit) {
        length[static_cast<std::size_t>(bit)] =
            by_order[static_cast<std::size_t>(neighbor_offset(bit).order())];
    }
    return length;
}();

/// Calls `visit(bit)` for every set bit, lowest first.
template <typename Visit>
void for_each_bit(Neighborhood set, Visit&& visit) {
    for (; set != 0; set &= set - 1) visit(std::countr_zero(set));
}

}  // namespace ossuary::skeleton
