#include "index/thumbnail/smooth_shading.h"

#include <algorithm>
#include <cmath>

namespace ossuary::index {

SmoothNormals::SmoothNormals(std::span<const Vec3f> vertices,
                             std::span<const std::array<std::uint32_t, 3>> triangles)
    : triangles_(triangles) {
    area_vectors_.reserve(triangles.size());
    unit_normals_.reserve(triangles.size());
    first_.assign(vertices.size() + 1, 0);
    for (const auto& [a, b, c] : triangles) {
        const Vec3f area = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
        const float length = area.norm();
        area_vectors_.push_back(area);
        unit_normals_.push_back(length > 0 ? Vec3f(area / length) : Vec3f::Zero());
        for (const std::uint32_t vertex : {a, b, c}) ++first_[vertex + 1];
    }
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) first_[v + 1] += first_[v];
    around_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (const std::uint32_t vertex : triangles[t]) around_[next[vertex]++] = t;
    }
}

/// Computed for the hits only: far fewer than the corners of a detailed model.
Vec3f SmoothNormals::corner_normal(std::uint32_t triangle, std::uint32_t vertex) const {
    constexpr float kCrease = 0.7071f;   // cosine of 45 degrees
    constexpr std::uint32_t kMost = 64;  // the hub of a fan has no use for all of its triangles
    const Vec3f& own = unit_normals_[triangle];
    Vec3f sum = area_vectors_[triangle];
    const std::uint32_t end = std::min(first_[vertex + 1], first_[vertex] + kMost);
    for (std::uint32_t i = first_[vertex]; i < end; ++i) {
        if (around_[i] == triangle) continue;
        const float cosine = own.dot(unit_normals_[around_[i]]);
        if (cosine > kCrease) sum += area_vectors_[around_[i]];
        if (cosine < -kCrease) sum -= area_vectors_[around_[i]];
    }
    return sum.norm() > 0 ? Vec3f(sum.normalized()) : own;
}

Vec3f SmoothNormals::at(const SampleHit& hit) const {
    const auto& [a, b, c] = triangles_[hit.triangle];
    Vec3f normal = (1 - hit.u - hit.v) * corner_normal(hit.triangle, a) +
                   hit.u * corner_normal(hit.triangle, b) + hit.v * corner_normal(hit.triangle, c);
    const float length = normal.norm();
    if (!(length > 0)) return Vec3f::UnitZ();
    normal /= length;
    // The side is that of the flat triangle, which is the one that is seen.
    return unit_normals_[hit.triangle].z() < 0 ? Vec3f(-normal) : normal;
}

Vec3f lit_color(const Vec3f& normal, const Vec3f& color) {
    const Vec3f key = Vec3f(-0.42f, -0.76f, 0.52f).normalized();
    const Vec3f fill = Vec3f(0.70f, 0.15f, 0.70f).normalized();
    const float diffuse = std::max(0.0f, normal.dot(key));
    const float filled = std::max(0.0f, normal.dot(fill));
    const float sky = 0.5f - 0.5f * normal.y();
    // Surfaces that turn away from the viewer darken, which draws the outlines.
    const float facing = std::clamp(normal.z(), 0.0f, 1.0f);
    const float outline = 0.55f + 0.45f * std::sqrt(facing);
    const float light = (0.20f + 0.16f * sky + 0.82f * diffuse + 0.24f * filled) * outline;
    const Vec3f half = (key + Vec3f::UnitZ()).normalized();
    const float towards2 = normal.dot(half) * normal.dot(half);
    const float towards8 = towards2 * towards2 * towards2 * towards2;
    const float sheen = 0.10f * towards8 * towards8 * towards8;
    return light * color + Vec3f::Constant(sheen);
}

}  // namespace ossuary::index
