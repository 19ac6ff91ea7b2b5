#include "engine/skeleton/simple_point.h"

#include <memory>

namespace ossuary {
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

/// Whether background_components is 1, with one growth instead of one for each component.
bool has_one_background_component(Neighborhood object) {
    const Neighborhood background = ~object & k18Neighbors;
    const Neighborhood faces = background & kFaceNeighbors;
    if (faces == 0) return false;
    const Neighborhood first = component_of(faces & (~faces + 1), background, dilate_6);
    return (faces & ~first) == 0;
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
    // Neighbourhoods and touched cells of the two halves of an 18-bit index, put together below.
    std::array<std::array<Neighborhood, 512>, 2> objects{};
    std::array<std::array<Neighborhood, 512>, 2> cells{};
    for (std::size_t half = 0; half < 2; ++half) {
        for (std::uint32_t bits = 1; bits < 512; ++bits) {
            const auto low = static_cast<std::size_t>(std::countr_zero(bits));
            const std::size_t bit = kTableOrder[8 + half * 9 + low];
            const std::uint32_t others = bits & (bits - 1);
            objects[half][bits] = objects[half][others] | Neighborhood{1} << bit;
            cells[half][bits] = cells[half][others] | kTouchedCells[bit];
        }
    }
    for (std::uint32_t index = 0; index < table_.size(); ++index) {
        const Neighborhood object = objects[0][index & 511u] | objects[1][index >> 9];
        Entry& entry = table_[index];
        if (!has_one_background_component(object)) {
            entry = {0, kNever};
            continue;
        }
        const Neighborhood touched = cells[0][index & 511u] | cells[1][index >> 9];
        const int faces = std::popcount(touched & kFaceNeighbors);
        const int edges = std::popcount(touched & kEdgeNeighbors);
        const int required = 1 + edges - faces;
        entry.required = required > 8 ? kNever - 1 : static_cast<std::uint8_t>(required);
        for (std::uint32_t corner = 0; corner < 8; ++corner) {
            if (touched >> kTableOrder[corner] & 1u) {
                entry.covered = static_cast<std::uint8_t>(entry.covered | 1u << corner);
            }
        }
    }
}

const SimplePointTest& SimplePointTest::shared() {
    static const auto instance = std::make_unique<const SimplePointTest>();
    return *instance;
}

}  // namespace ossuary
