#include "index/upright.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

namespace ossuary::index {
namespace {

using Vec2 = Eigen::Vector2d;

/// So much more must speak for an axis than for the convention's.
constexpr double kMargin = 0.03;

int axis_of(Up up) { return static_cast<int>(up); }

Box3 bounds_of(const mesh::TriangleMesh& mesh) {
    Box3 bounds;
    for (const mesh::TriangleMesh::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) bounds.extend(mesh.vertices[corner]);
    }
    return bounds;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Area of the convex hull (Andrew's monotone chain).
double hull_area(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    double doubled = 0.0;
    const auto add_chain = [&](auto begin, auto end) {
        std::vector<Vec2> chain;
        for (auto point = begin; point != end; ++point) {
            while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), *point) <= 0.0) {
                chain.pop_back();
            }
            chain.push_back(*point);
        }
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            doubled += chain[i].x() * chain[i + 1].y() - chain[i].y() * chain[i + 1].x();
        }
    };
    if (points.empty()) return 0.0;
    const Vec2 origin = points.front();  // so that a place far away costs no digits
    for (Vec2& point : points) point -= origin;
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return 0.5 * std::abs(doubled);
}

double footprint(const mesh::TriangleMesh& mesh, const Box3& bounds, int axis) {
    constexpr double kNearGround = 0.02;  // of the diagonal
    const double ground = bounds.min()[axis] + kNearGround * bounds.sizes().norm();
    std::vector<Vec2> shadow, support;
    for (const mesh::TriangleMesh::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            const Vec3& vertex = mesh.vertices[corner];
            const Vec2 point(vertex[(axis + 1) % 3], vertex[(axis + 2) % 3]);
            shadow.push_back(point);
            if (vertex[axis] <= ground) support.push_back(point);
        }
    }
    const double whole = hull_area(std::move(shadow));
    return whole > 0.0 ? std::min(1.0, hull_area(std::move(support)) / whole) : 0.0;
}

/// Surface area in cubic cells, 24 along the longest side, with the model's middle in the middle.
class AreaGrid {
public:
    AreaGrid(const mesh::TriangleMesh& mesh, const Box3& bounds)
        : cell_(bounds.sizes().maxCoeff() / kCells), middle_(bounds.center()) {
        for (int k = 0; k < 3; ++k) {
            const double cells = std::ceil(bounds.sizes()[k] / cell_ - 1e-9);
            size_[static_cast<std::size_t>(k)] = std::clamp(static_cast<int>(cells), 1, kCells);
        }
        area_.resize(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]), 0.0);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) add(mesh.corners(t));
        for (int axis = 0; axis < 3; ++axis) blur(axis);
    }

    /// The least share of the area without a mirror image, over mirrors across `axis` that lie up
    /// to a tenth of the model's length from its middle.
    [[nodiscard]] double lopsidedness(int axis) const {
        const int n = size_[static_cast<std::size_t>(axis)];
        const int farthest = n > 1 ? std::max(1, n / 5) : 0;  // in half cells
        double best = 1.0;
        for (int shift = -farthest; shift <= farthest; ++shift) {
            best = std::min(best, without_image(axis, n - 1 + shift));
        }
        return best;
    }

private:
    static constexpr int kCells = 24;

    [[nodiscard]] std::size_t at(const std::array<int, 3>& c) const {
        return static_cast<std::size_t>((c[0] * size_[1] + c[1]) * size_[2] + c[2]);
    }
    template <typename Body>
    void for_each_cell(const Body& body) const {
        std::array<int, 3> c{};
        for (c[0] = 0; c[0] < size_[0]; ++c[0]) {
            for (c[1] = 0; c[1] < size_[1]; ++c[1]) {
                for (c[2] = 0; c[2] < size_[2]; ++c[2]) body(c);
            }
        }
    }

    /// Cuts the triangle into pieces of at most a third of a cell; each counts where its middle is.
    void add(const std::array<Vec3, 3>& corners) {
        const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
        const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
        const int pieces = std::clamp(static_cast<int>(std::ceil(3.0 * longest / cell_)), 1, 64);
        const double area = 0.5 * u.cross(v).norm() / (pieces * pieces);
        for (int i = 0; i < pieces; ++i) {
            for (int j = 0; j < pieces - i; ++j) {
                add_point(corners[0] + ((i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v) / pieces, area);
                if (j + 1 == pieces - i) continue;
                add_point(corners[0] + ((i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v) / pieces, area);
            }
        }
    }
    void add_point(const Vec3& point, double area) {
        std::array<int, 3> c{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double cell = (point[axis] - middle_[axis]) / cell_ + size_[k] / 2.0;
            c[k] = std::clamp(static_cast<int>(std::floor(cell)), 0, size_[k] - 1);
        }
        area_[at(c)] += area;
    }
    /// So that a cell's border through a surface does not tell it from its image.
    void blur(int axis) {
        const auto k = static_cast<std::size_t>(axis);
        std::vector<double> blurred(area_.size());
        for_each_cell([&](std::array<int, 3> c) {
            double sum = area_[at(c)];
            const std::size_t here = at(c);
            const int middle = c[k];
            for (const int next : {middle - 1, middle + 1}) {
                if (next < 0 || next >= size_[k]) continue;
                c[k] = next;
                sum += 0.5 * area_[at(c)];
            }
            blurred[here] = sum;
        });
        area_ = std::move(blurred);
    }
    /// @param sum  of the places of a cell and of its image along `axis`
    [[nodiscard]] double without_image(int axis, int sum) const {
        const auto k = static_cast<std::size_t>(axis);
        double all = 0.0, matched = 0.0;
        for_each_cell([&](std::array<int, 3> c) {
            const double here = area_[at(c)];
            all += here;
            c[k] = sum - c[k];
            if (c[k] >= 0 && c[k] < size_[k]) matched += std::min(here, area_[at(c)]);
        });
        return all > 0.0 ? std::clamp(1.0 - matched / all, 0.0, 1.0) : 0.0;
    }

    double cell_;
    Vec3 middle_;
    std::array<int, 3> size_{};
    std::vector<double> area_;
};

}  // namespace

UprightEvidence upright_evidence(const mesh::TriangleMesh& mesh, Up up) {
    const Box3 bounds = bounds_of(mesh);
    assert(!bounds.isEmpty() && bounds.sizes().maxCoeff() > 0.0);
    const int axis = axis_of(up);
    return {footprint(mesh, bounds, axis), AreaGrid(mesh, bounds).lopsidedness(axis)};
}

// Of 269 models of the segmentation benchmark and 180 of OpenArena's characters 227 and 153 come to
// stand upright (186 and 0 if y were always up); by flat area near the ground 155 to 190 and at
// most 57, by the footprint alone 218 and 108, by lopsidedness alone at most 191 and 158.
Up find_up(const mesh::TriangleMesh& mesh, Up convention) {
    const Box3 bounds = bounds_of(mesh);
    if (bounds.isEmpty() || !(bounds.sizes().maxCoeff() > 0.0)) return convention;
    const auto weight = [&](Up up) {
        const UprightEvidence evidence = upright_evidence(mesh, up);
        return evidence.footprint + evidence.lopsidedness;
    };
    const Up other = convention == Up::kY ? Up::kZ : Up::kY;
    return weight(other) > weight(convention) + kMargin ? other : convention;
}

}  // namespace ossuary::index
