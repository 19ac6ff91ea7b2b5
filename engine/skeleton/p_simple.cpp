#include "engine/skeleton/p_simple.h"

namespace ossuary::skeleton {
namespace {

/// The cells one step from those of a set, in one of the six directions.
template <int kBits>
constexpr Neighborhood shifted(Neighborhood set, Neighborhood within) {
    return kBits > 0 ? (set & within) << kBits : (set & within) >> -kBits;
}

/// Face neighbours y with a background face neighbour z and a background edge neighbour t that
/// close a unit square with y and the centre: t is where y and z, taken as steps, lead together.
/// The background is passed without corners and centre, so that only edge neighbours remain where
/// a step leads along another axis.
Neighborhood faces_beside_background(Neighborhood background) {
    const Neighborhood faces = background & kFaceNeighbors;
    const Neighborhood edges = background & kEdgeNeighbors;
    const auto face = [&](Neighborhood reached, int dx, int dy, int dz) {
        const Neighborhood bit = Neighborhood{1} << neighbor_bit({dx, dy, dz});
        return (reached & edges) != 0 ? bit : 0;
    };
    return face(shifted<-1>(faces, detail::kNotLowX), -1, 0, 0) |
           face(shifted<1>(faces, detail::kNotHighX), 1, 0, 0) |
           face(shifted<-3>(faces, detail::kNotLowY), 0, -1, 0) |
           face(shifted<3>(faces, detail::kNotHighY), 0, 1, 0) |
           face(shifted<-9>(faces, kWholeNeighborhood), 0, 0, -1) |
           face(shifted<9>(faces, kWholeNeighborhood), 0, 0, 1);
}

/// Whether a set of neighbours, not empty, is one 26-component. Where its background is one, as
/// nearly always, the table of simple points knows.
bool is_one_component(const SimplePointTest& simple_point, Neighborhood set) {
    if (simple_point(set)) return true;
    if (simple_point.one_background_component(set)) return false;
    Neighborhood component = set & (~set + 1);
    for (;;) {
        const Neighborhood grown = dilate_26(component) & set;
        if (grown == component) return component == set;
        component = grown;
    }
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
    if (!is_one_component(simple_point, staying)) return false;
    const Neighborhood faces = candidates & kFaceNeighbors;
    return faces == 0 || (faces & ~faces_beside_background(~object & k18Neighbors)) == 0;
}

}  // namespace ossuary::skeleton
