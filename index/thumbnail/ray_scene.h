#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/result.h"

namespace ossuary::index {

/// Where a ray meets the surface first.
struct RayHit {
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    std::uint32_t triangle = kNone;
    float u = 0.0f;  ///< barycentric weight of the triangle's second corner
    float v = 0.0f;  ///< and of its third
};

/// Triangles that rays along -z can be sent at (Embree behind it).
class RayScene {
public:
    /// Errors: out_of_memory, internal.
    static Result<RayScene> build(std::span<const Vec3f> vertices,
                                  std::span<const std::array<std::uint32_t, 3>> triangles);
    ~RayScene();
    RayScene(RayScene&& other) noexcept;
    RayScene& operator=(RayScene&& other) noexcept;

    /// The first hits of rays that start at `origins` and run along -z; as long as `origins`.
    /// Neighbouring rays should follow each other: they travel in packets.
    void first_hits(std::span<const Vec3f> origins, std::span<RayHit> hits) const;

private:
    struct Handles;
    explicit RayScene(std::unique_ptr<Handles> handles);
    std::unique_ptr<Handles> handles_;
};

}  // namespace ossuary::index
