#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

struct SampleSurfaceOptions {
    std::size_t count = 1024;
    std::uint64_t seed = 1;
    /// One sample from each of `count` equal parts of the area, in the order of the triangles,
    /// which spreads them more evenly than independent draws; each is still uniform over its part.
    bool stratified = true;
};

struct SurfaceSample {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero();  ///< of the triangle, unit length
    std::uint32_t triangle = 0;
    Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's corners
};

/// Points spread uniformly over the area. The same on every platform for the same seed (the 64-bit
/// Mersenne Twister and mappings of our own). Empty for a mesh without area.
std::vector<SurfaceSample> sample_surface(const TriangleMesh& mesh,
                                          const SampleSurfaceOptions& options = {});

}  // namespace ossuary::mesh
