#include "engine/skeleton/deletion_templates.h"

#include <algorithm>

namespace ossuary::skeleton {
namespace {

struct Template {
    Neighborhood relevant = 0;
    Neighborhood black = 0;
    bool operator==(const Template&) const = default;
};

constexpr int axis_of(const NeighborOffset& o, int axis) {
    return axis == 0 ? o.dx : axis == 1 ? o.dy : o.dz;
}

constexpr Neighborhood face_bit(int axis, int sign) {
    NeighborOffset o;
    (axis == 0 ? o.dx : axis == 1 ? o.dy : o.dz) = sign;
    return Neighborhood{1} << neighbor_bit(o);
}

template <typename Predicate>
constexpr Neighborhood select(Predicate predicate) {
    Neighborhood set = 0;
    for (int bit = 0; bit < 27; ++bit) {
        if (bit != kCentreBit && predicate(neighbor_offset(bit))) set |= Neighborhood{1} << bit;
    }
    return set;
}

constexpr std::array<Template, 38> make_templates() {
    std::array<Template, 38> templates{};
    std::size_t next = 0;
    const auto add = [&](Neighborhood white, Neighborhood black) {
        templates[next++] = {white | black, black};
    };
    constexpr std::array<int, 2> signs = {-1, 1};
    for (int axis = 0; axis < 3; ++axis) {  // class A
        for (const int s : signs) {
            add(select([&](const NeighborOffset& o) { return axis_of(o, axis) == s; }),
                face_bit(axis, -s));
        }
    }
    for (int along = 0; along < 3; ++along) {  // classes B and D, about an edge along one axis
        const int u = (along + 1) % 3;
        const int v = (along + 2) % 3;
        for (const int su : signs) {
            for (const int sv : signs) {
                add(select([&](const NeighborOffset& o) {
                        const int a = su * axis_of(o, u);
                        const int b = sv * axis_of(o, v);
                        return (a == 1 && b >= 0) || (b == 1 && a >= 0);
                    }),
                    face_bit(u, -su) | face_bit(v, -sv));
                const auto is_black = [&](const NeighborOffset& o) {
                    return axis_of(o, along) == 0 && axis_of(o, u) == su && axis_of(o, v) == sv;
                };
                add(select([&](const NeighborOffset& o) {
                        return axis_of(o, along) == 0 && !is_black(o);
                    }),
                    select(is_black));
            }
        }
    }
    for (const int sx : signs) {  // class C
        for (const int sy : signs) {
            for (const int sz : signs) {
                add(select([&](const NeighborOffset& o) {
                        return sx * o.dx >= 0 && sy * o.dy >= 0 && sz * o.dz >= 0;
                    }),
                    face_bit(0, -sx) | face_bit(1, -sy) | face_bit(2, -sz));
            }
        }
    }
    return templates;
}

constexpr std::array<Template, 38> kTemplates = make_templates();

}  // namespace

bool matches_deletion_template(Neighborhood object) {
    return std::any_of(kTemplates.begin(), kTemplates.end(),
                       [object](const Template& t) { return (object & t.relevant) == t.black; });
}

bool is_tail(Neighborhood object) {
    const Neighborhood neighbors = object & k26Neighbors;
    const int count = std::popcount(neighbors);
    if (count <= 1) return true;
    if (count > 2) return false;
    return (dilate_26(neighbors & (~neighbors + 1)) & neighbors) == neighbors;
}

}  // namespace ossuary::skeleton
