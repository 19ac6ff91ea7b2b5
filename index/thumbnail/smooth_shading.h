#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "index/thumbnail/sample_hits.h"

namespace ossuary::index {

/// Normals that vary smoothly over curved surfaces and jump at creases, whichever way the single
/// triangles face.
class SmoothNormals {
public:
    SmoothNormals(std::span<const Vec3f> vertices,
                  std::span<const std::array<std::uint32_t, 3>> triangles);

    /// The unit normal at a hit, turned towards +z; +z itself where nothing has area.
    [[nodiscard]] Vec3f at(const SampleHit& hit) const;

private:
    [[nodiscard]] Vec3f corner_normal(std::uint32_t triangle, std::uint32_t vertex) const;

    std::span<const std::array<std::uint32_t, 3>> triangles_;
    std::vector<Vec3f> area_vectors_;  // normal times twice the area
    std::vector<Vec3f> unit_normals_;
    std::vector<std::uint32_t> first_;  // triangles around v: [first_[v], first_[v + 1])
    std::vector<std::uint32_t> around_;
};

/// Linear light of a surface of linear `color` with `normal`, seen from +z with y downwards: a key
/// light from above left, a weak fill from the right, light from the sky, and a faint sheen.
[[nodiscard]] Vec3f lit_color(const Vec3f& normal, const Vec3f& color);

}  // namespace ossuary::index
