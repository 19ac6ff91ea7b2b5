#include "engine/skeleton/simple_point.h"

#include <memory>

namespace ossuary::skeleton {
namespace {

constexpr std::array<std::uint8_t, 26> kTableOrder = [] {
    // Corners first (bits 0-7 of an index), then faces and edges (bits 8-25).
    std::array<std::uint8_t, 26> order{};
    std::size_t next = 0;
    for (const Neighborhood set : {kCornerNeighbors, k18Neighbors}) {
        for (int bit = 0; bit < 27; ++bit) {
            if (set >> bit & 1u) order[next++] = static_cast<std::uint8_t>(bit);
        }
    }
    return order;
}();

/// The cells of the centre's surface (named by the neighbour that sits on them) that a neighbour
/// touches: a face neighbour its face, four edges and four corners, and so on.
constexpr std::array<Neighborhood, 27> kTouchedCells = [] {
    std::array<Neighborhood, 27> touched{};
    for (int bit = 0; bit < 27; ++bit) {
        const NeighborOffset n = neighbor_offset(bit);
        for (int cell = 0; cell < 27; ++cell) {
            const NeighborOffset c = neighbor_offset(cell);
            const bool inside = (n.dx == 0 || n.dx == c.dx) && (n.dy == 0 || n.dy == c.dy) &&
                                (n.dz == 0 || n.dz == c.dz);
            if (inside && bit != kCentreBit) {
                touched[static_cast<std::size_t>(bit)] |= Neighborhood{1} << cell;
            }
        }
    }
    return touched;
}();

template <typename Dilate>
Neighborhood component_of(Neighborhood seed, Neighborhood set, Dilate dilate) {
    for (;;) {
        const Neighborhood grown = dilate(seed) & set;
        if (grown == seed) return grown;
        seed = grown;
    }
}

}  // namespace

int object_components(Neighborhood object) {
    Neighborhood rest = object & k26Neighbors;
    int count = 0;
    for (; rest != 0; ++count) {
        rest &= ~component_of(rest & (~rest + 1), rest, dilate_26);
    }
    return count;
}

int background_components(Neighborhood object) {
    const Neighborhood background = ~object & k18Neighbors;
    Neighborhood rest = background & kFaceNeighbors;
    int count = 0;
    for (; rest != 0; ++count) {
        rest &= ~component_of(rest & (~rest + 1), background, dilate_6);
    }
    return count;
}

bool is_simple_by_definition(Neighborhood object) {
    return object_components(object) == 1 && background_components(object) == 1;
}

SimplePointTest::SimplePointTest() {
    for (std::uint32_t index = 0; index < 26; ++index) {
        const std::uint32_t bit = kTableOrder[index];
        for (std::uint32_t plane = 0; plane < 512; ++plane) {
            if (plane >> bit % 9 & 1u) planes_[bit / 9][plane] |= 1u << index;
        }
    }
}

std::uint32_t SimplePointTest::make_entry(std::uint32_t faces_and_edges) const {
    Neighborhood object = 0;
    Neighborhood touched = 0;
    for (std::uint32_t rest = faces_and_edges; rest != 0; rest &= rest - 1) {
        const std::size_t bit = kTableOrder[8 + static_cast<std::size_t>(std::countr_zero(rest))];
        object |= Neighborhood{1} << bit;
        touched |= kTouchedCells[bit];
    }
    std::uint32_t entry = kNever << 8;
    if (background_components(object) == 1) {
        const int faces = std::popcount(touched & kFaceNeighbors);
        const int edges = std::popcount(touched & kEdgeNeighbors);
        const auto required = static_cast<std::uint32_t>(1 + edges - faces);
        entry = (required > 8 ? kNever - 1 : required) << 8;
        for (std::uint32_t corner = 0; corner < 8; ++corner) {
            if (touched >> kTableOrder[corner] & 1u) entry |= 1u << corner;
        }
    }
    table_[faces_and_edges].store(static_cast<std::uint16_t>(entry), std::memory_order_relaxed);
    return entry;
}

const SimplePointTest& SimplePointTest::shared() {
    static const auto instance = std::make_unique<const SimplePointTest>();
    return *instance;
}

}  // namespace ossuary::skeleton
