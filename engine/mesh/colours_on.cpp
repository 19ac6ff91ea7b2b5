#include "engine/mesh/colours_on.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/mesh/measures.h"
#include "engine/mesh/nearest_triangle.h"
#include "engine/mesh/vertex_normals.h"

namespace ossuary::mesh {
namespace {

/// What a sheet that faces the other way counts as farther, in parts of the bounding box's
/// diagonal: as for labels (carry_labels.cpp), of which flat colours are a kind.
constexpr double kTurnedDistance = 0.002;

/// The share of each corner in a point of a triangle; all of the nearest one where it has no area.
Vec3 weights_of(const std::array<Vec3, 3>& corners, const Vec3& point) {
    const auto& [a, b, c] = corners;
    const Vec3 normal = (b - a).cross(c - a);
    const double doubled = normal.squaredNorm();
    Vec3 weights = Vec3::Zero();
    if (doubled > 0.0) {
        weights = Vec3(normal.dot((c - b).cross(point - b)), normal.dot((a - c).cross(point - c)),
                       normal.dot((b - a).cross(point - a)))
                      .cwiseMax(0.0);
        const double sum = weights.sum();
        if (sum > 0.0 && std::isfinite(sum)) return weights / sum;
    }
    Eigen::Index nearest = 0;
    Vec3((a - point).norm(), (b - point).norm(), (c - point).norm()).minCoeff(&nearest);
    weights.setZero();
    weights[nearest] = 1.0;
    return weights;
}

std::vector<CornerColours> flat_colours_on(const TriangleMesh& copy, const TriangleMesh& mesh) {
    const NearestTriangle nearest(mesh, kTurnedDistance * measure(mesh).diagonal);
    const std::vector<Vec3> normals = triangle_normals(copy);
    std::vector<CornerColours> colours;
    colours.reserve(copy.triangles.size());
    for (std::size_t t = 0; t < copy.triangles.size(); ++t) {
        const auto [a, b, c] = copy.corners(t);
        colours.push_back(mesh.corner_colours[nearest.of((a + b + c) / 3.0, normals[t])]);
    }
    return colours;
}

std::vector<CornerColours> smooth_colours_on(const TriangleMesh& copy, const TriangleMesh& mesh) {
    const NearestTriangle nearest(mesh);
    std::vector<Colour> of_vertex;
    of_vertex.reserve(copy.vertices.size());
    for (const Vec3& vertex : copy.vertices) {
        const std::uint32_t t = nearest.of(vertex, Vec3::Zero());
        const std::array<Vec3, 3> corners = mesh.corners(t);
        const Vec3 weights = weights_of(corners, nearest_point_of(corners, vertex));
        of_vertex.push_back(colour_at(mesh.corner_colours[t], weights));
    }
    std::vector<CornerColours> colours;
    colours.reserve(copy.triangles.size());
    for (const auto& [a, b, c] : copy.triangles) {
        colours.push_back({of_vertex[a], of_vertex[b], of_vertex[c]});
    }
    return colours;
}

}  // namespace

Colour colour_at(const CornerColours& colours, const Vec3& weights) {
    Colour colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Vec3 bytes(colours[0][channel], colours[1][channel], colours[2][channel]);
        colour[channel] =
            static_cast<std::uint8_t>(std::lround(std::clamp(bytes.dot(weights), 0.0, 255.0)));
    }
    return colour;
}

bool is_white(const TriangleMesh& mesh) {
    constexpr Colour kWhite = {255, 255, 255};
    const auto& colours = mesh.corner_colours;
    return !colours.empty() && std::all_of(colours.begin(), colours.end(), [&](const auto& each) {
        return each == CornerColours{kWhite, kWhite, kWhite};
    });
}

bool has_flat_colours(const TriangleMesh& mesh) {
    return std::all_of(
        mesh.corner_colours.begin(), mesh.corner_colours.end(),
        [](const CornerColours& each) { return each[0] == each[1] && each[1] == each[2]; });
}

std::vector<CornerColours> colours_on(const TriangleMesh& copy, const TriangleMesh& mesh) {
    if (mesh.corner_colours.empty()) return {};
    return has_flat_colours(mesh) ? flat_colours_on(copy, mesh) : smooth_colours_on(copy, mesh);
}

}  // namespace ossuary::mesh
