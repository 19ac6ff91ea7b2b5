#pragma once

#include <atomic>

#include "engine/skeleton/neighborhood.h"

namespace ossuary::skeleton {

/// Whether removing the centre keeps the topology of a (26, 6) volume, straight from the
/// definition: the object in the 26-neighbourhood has exactly one 26-component, and the background
/// in the 18-neighbourhood exactly one 6-component that touches the centre by a face (Bertrand &
/// Malandain, "A new characterization of three-dimensional simple points", 1994, prop. 5). The
/// state of the centre itself is ignored. Slow; the yardstick of SimplePointTest.
[[nodiscard]] bool is_simple_by_definition(Neighborhood object);

/// Number of 6-components of the background in the 18-neighbourhood that touch the centre by a
/// face (the topological number T6).
[[nodiscard]] int background_components(Neighborhood object);

/// Number of 26-components of the set in the 26-neighbourhood (the topological number T26).
[[nodiscard]] int object_components(Neighborhood object);

/// The same decision as is_simple_by_definition with one look into a table of 2^18 entries.
///
/// The object's neighbours cut a set L of faces, edges and corners out of the centre's surface.
/// By Helly's theorem for boxes L has as many components as the object has 26-components, and
/// the rest of that sphere as many as T6 counts. With T6 = 1 the set L has no hole, so its Euler
/// number V - E + F counts its components: the point is simple when T6 = 1 and V - E + F = 1. T6,
/// E and F depend on the 18-neighbourhood alone, which indexes the table; V needs the corners too.
/// (A table of all 2^26 neighbourhoods takes 8 MB and 16 times as long to fill; this one, .5 MB,
/// stays in the second-level cache.)
class SimplePointTest {
public:
    SimplePointTest();

    [[nodiscard]] bool operator()(Neighborhood object) const {
        const std::uint32_t index = index_of(object);
        const std::uint32_t entry = entry_at(index >> 8);
        return entry >> 8 ==
               static_cast<std::uint32_t>(std::popcount((entry | index) & std::uint32_t{255}));
    }

    /// Whether T6 = 1.
    [[nodiscard]] bool one_background_component(Neighborhood object) const {
        return entry_at(index_of(object) >> 8) >> 8 != kNever;
    }

    /// The one instance that everybody shares.
    static const SimplePointTest& shared();

private:
    static constexpr std::uint32_t kNever = 255;

    [[nodiscard]] std::uint32_t index_of(Neighborhood object) const {
        return planes_[0][object & 511u] | planes_[1][object >> 9 & 511u] |
               planes_[2][object >> 18];
    }
    [[nodiscard]] std::uint32_t entry_at(std::uint32_t faces_and_edges) const {
        const std::uint32_t known = table_[faces_and_edges].load(std::memory_order_relaxed);
        return known != 0 ? known : make_entry(faces_and_edges);
    }
    std::uint32_t make_entry(std::uint32_t faces_and_edges) const;

    /// Where the bits of each plane of nine go: 18 face and edge bits above 8 corner bits.
    std::array<std::array<std::uint32_t, 512>, 3> planes_{};
    /// By face and edge bits: in the low byte the corners of the centre that faces and edges
    /// already touch, above it how many corners L must have for V - E + F = 1, or kNever. An entry
    /// is made when it is first needed (filling all takes 6 ms, a thinning needs a few thousand)
    /// and is never 0; whoever makes it makes the same.
    mutable std::array<std::atomic<std::uint16_t>, std::size_t{1} << 18> table_{};
};

}  // namespace ossuary::skeleton
