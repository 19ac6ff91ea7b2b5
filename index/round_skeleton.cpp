#include "index/round_skeleton.h"

#include <cmath>

#include "index/grid_numbers.h"

namespace ossuary::index {

namespace {

constexpr int kSkeletonBits = 18;

Box3 bounds_of_skeleton(const skeleton::SkeletonGraph& graph) {
    Box3 bounds;
    for (const auto& node : graph.nodes) bounds.extend(node.position);
    for (const auto& branch : graph.branches) {
        for (const Vec3& point : branch.points) bounds.extend(point);
    }
    return bounds;
}

}  // namespace

skeleton::SkeletonGraph round_skeleton(skeleton::SkeletonGraph graph) {
    double extent = 0.0;
    const Box3 bounds = bounds_of_skeleton(graph);
    if (!bounds.isEmpty()) extent = bounds.sizes().maxCoeff();
    for (const auto& node : graph.nodes) extent = std::max(extent, node.radius);
    if (!(extent > 0.0) || !std::isfinite(extent)) return graph;
    const int exponent = std::ilogb(extent) - kSkeletonBits;
    const auto round = [exponent](double& number) { number = round_to_grid(number, exponent); };
    const auto round_point = [&](Vec3& point) {
        for (double& coordinate : point) round(coordinate);
    };
    for (auto& node : graph.nodes) {
        round_point(node.position);
        round(node.radius);
    }
    for (auto& branch : graph.branches) {
        for (Vec3& point : branch.points) round_point(point);
        for (double& radius : branch.radii) round(radius);
    }
    return graph;
}

}  // namespace ossuary::index
