#include "engine/skeleton/p_simple.h"

namespace ossuary {
namespace {

/// For each edge neighbour the two face neighbours that form a unit square with it and the centre.
struct UnitSquare {
    Neighborhood edge = 0;
    Neighborhood face_a = 0;
    Neighborhood face_b = 0;
};

constexpr std::array<UnitSquare, 12> kUnitSquares = [] {
    std::array<UnitSquare, 12> squares{};
    std::size_t next = 0;
    for (int bit = 0; bit < 27; ++bit) {
        const NeighborOffset o = neighbor_offset(bit);
        if (o.order() != 2) continue;
        const NeighborOffset a =
            o.dx != 0 ? NeighborOffset{o.dx, 0, 0} : NeighborOffset{0, o.dy, 0};
        const NeighborOffset b =
            o.dz != 0 ? NeighborOffset{0, 0, o.dz} : NeighborOffset{0, o.dy, 0};
        squares[next++] = {Neighborhood{1} << bit, Neighborhood{1} << neighbor_bit(a),
                           Neighborhood{1} << neighbor_bit(b)};
    }
    return squares;
}();

/// Face neighbours y with a background face neighbour z and a background edge neighbour t that
/// close a unit square with y and the centre.
Neighborhood faces_beside_background(Neighborhood object) {
    const Neighborhood background = ~object;
    Neighborhood faces = 0;
    for (const UnitSquare& square : kUnitSquares) {
        if ((background & square.edge) == 0) continue;
        if ((background & square.face_a) != 0) faces |= square.face_b;
        if ((background & square.face_b) != 0) faces |= square.face_a;
    }
    return faces;
}

}  // namespace

bool is_p_simple(const SimplePointTest& simple_point, Neighborhood object,
                 Neighborhood candidates) {
    if (!simple_point(object)) return false;
    candidates &= k26Neighbors;
    if (candidates == 0) return true;
    const Neighborhood staying = object & k26Neighbors & ~candidates;
    if (staying == 0) return false;
    if ((candidates & ~dilate_26(staying)) != 0) return false;
    Neighborhood component = staying & (~staying + 1);
    for (;;) {
        const Neighborhood grown = dilate_26(component) & staying;
        if (grown == component) break;
        component = grown;
    }
    if (component != staying) return false;
    const Neighborhood faces = candidates & kFaceNeighbors;
    return (faces & ~faces_beside_background(object)) == 0;
}

}  // namespace ossuary
