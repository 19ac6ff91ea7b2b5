#include "engine/mesh/nearest_triangle.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "engine/mesh/vertex_normals.h"

namespace ossuary::mesh {
namespace {

constexpr std::uint32_t kLeafTriangles = 4;

Vec3 nearest_point_of_segment(const Vec3& a, const Vec3& b, const Vec3& point) {
    const Vec3 along = b - a;
    const double squared = along.squaredNorm();
    if (squared <= 0.0) return a;
    return a + std::clamp((point - a).dot(along) / squared, 0.0, 1.0) * along;
}

}  // namespace

Vec3 nearest_point_of(const std::array<Vec3, 3>& corners, const Vec3& point) {
    const auto& [a, b, c] = corners;
    const Vec3 normal = (b - a).cross(c - a);
    // Inside the prism over the triangle its plane is nearest, elsewhere one of its sides.
    if (normal.squaredNorm() > 0.0 && normal.dot((b - a).cross(point - a)) >= 0.0 &&
        normal.dot((c - b).cross(point - b)) >= 0.0 &&
        normal.dot((a - c).cross(point - c)) >= 0.0) {
        return point - normal * (normal.dot(point - a) / normal.squaredNorm());
    }
    Vec3 nearest = nearest_point_of_segment(a, b, point);
    for (const auto& [from, to] : {std::pair(&b, &c), std::pair(&c, &a)}) {
        const Vec3 other = nearest_point_of_segment(*from, *to, point);
        if ((other - point).squaredNorm() < (nearest - point).squaredNorm()) nearest = other;
    }
    return nearest;
}

NearestTriangle::NearestTriangle(const TriangleMesh& mesh, double turned_distance)
    : mesh_(mesh),
      turned_cost_(turned_distance * turned_distance / 2.0),
      normals_(triangle_normals(mesh)),
      order_(mesh.triangles.size()) {
    assert(!mesh.triangles.empty());
    std::vector<Item> items;
    items.reserve(order_.size());
    for (std::uint32_t t = 0; t < order_.size(); ++t) {
        const auto [a, b, c] = mesh.corners(t);
        items.push_back({(a + b + c) / 3.0, t});
    }
    nodes_.reserve(4 * order_.size() / kLeafTriangles + 1);
    build(items, 0, static_cast<std::uint32_t>(items.size()));
}

Box3 NearestTriangle::build(std::vector<Item>& items, std::uint32_t begin, std::uint32_t end) {
    const std::size_t node = nodes_.size();
    nodes_.push_back({Box3(), begin, end - begin});
    Box3 box;
    if (end - begin <= kLeafTriangles) {
        for (std::uint32_t i = begin; i < end; ++i) {
            order_[i] = items[i].triangle;
            for (const Vec3& corner : mesh_.corners(order_[i])) box.extend(corner);
        }
    } else {
        Box3 of_centers;
        for (std::uint32_t i = begin; i < end; ++i) of_centers.extend(items[i].center);
        Eigen::Index axis = 0;
        of_centers.sizes().maxCoeff(&axis);
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(
            items.begin() + begin, items.begin() + middle, items.begin() + end,
            [axis](const Item& a, const Item& b) { return a.center[axis] < b.center[axis]; });
        box = build(items, begin, middle);
        nodes_[node].count = 0;
        nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
        box.extend(build(items, middle, end));
    }
    nodes_[node].box = box;
    return box;
}

void NearestTriangle::search(std::uint32_t node, Query& query) const {
    const Node& here = nodes_[node];
    query.looked_at += std::max(here.count, std::uint32_t{1});
    for (std::uint32_t i = here.first; i < here.first + here.count; ++i) {
        const std::uint32_t triangle = order_[i];
        const Vec3 nearest = nearest_point_of(mesh_.corners(triangle), query.point);
        const double cost = (nearest - query.point).squaredNorm() +
                            turned_cost_ * (1.0 - query.normal.dot(normals_[triangle]));
        if (std::pair(cost, triangle) < std::pair(query.best_cost, query.best)) {
            query.best_cost = cost;
            query.best = triangle;
        }
    }
    if (here.count > 0) return;
    using Child = std::pair<double, std::uint32_t>;
    Child near(nodes_[node + 1].box.squaredExteriorDistance(query.point), node + 1);
    Child far(nodes_[here.first].box.squaredExteriorDistance(query.point), here.first);
    if (far < near) std::swap(near, far);
    // Equally far boxes are looked into too, for the lower number.
    for (const auto& [squared, child] : {near, far}) {
        if (squared <= query.best_cost && query.looked_at < kMostLookedAt) search(child, query);
    }
}

std::uint32_t NearestTriangle::of(const Vec3& point, const Vec3& normal) const {
    Query query{point, normal, std::numeric_limits<double>::infinity(), 0, 0};
    search(0, query);
    return query.best;
}

}  // namespace ossuary::mesh
