#pragma once

#include "engine/skeleton/neighborhood.h"

namespace ossuary {

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
        const std::uint32_t index =
            planes_[0][object & 511u] | planes_[1][object >> 9 & 511u] | planes_[2][object >> 18];
        const Entry entry = table_[index >> 8];
        return entry.required ==
               std::popcount(static_cast<std::uint8_t>(entry.covered | (index & 255u)));
    }

    /// Whether T6 = 1.
    [[nodiscard]] bool one_background_component(Neighborhood object) const {
        const std::uint32_t index =
            planes_[0][object & 511u] | planes_[1][object >> 9 & 511u] | planes_[2][object >> 18];
        return table_[index >> 8].required != kNever;
    }

    /// The one instance that everybody shares, filled on first use.
    static const SimplePointTest& shared();

private:
    struct Entry {
        std::uint8_t covered = 0;   ///< corners of the centre that faces and edges already touch
        std::uint8_t required = 0;  ///< how many corners L must have for V - E + F = 1
    };
    static constexpr std::uint8_t kNever = 255;

    /// Where the bits of each plane of nine go: 18 face and edge bits above 8 corner bits.
    std::array<std::array<std::uint32_t, 512>, 3> planes_{};
    std::array<Entry, std::size_t{1} << 18> table_{};
};

}  // namespace ossuary
