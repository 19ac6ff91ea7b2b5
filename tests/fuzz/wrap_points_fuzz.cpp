// Wraps points whose coordinates are arbitrary, on a small grid.

#include "engine/voxel/wrap_points.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "engine/mesh/inspect.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using ossuary::fuzz::require;
    std::vector<ossuary::Vec3> points;
    for (std::size_t at = 0; at + 6 <= size; at += 6) {
        std::int16_t numbers[3];
        std::memcpy(numbers, data + at, 6);
        // From tiny to huge: the third number's low bits stretch one axis.
        const double stretch = std::ldexp(1.0, (numbers[2] & 7) * 12 - 40);
        points.emplace_back(numbers[0] * stretch, numbers[1], numbers[2]);
    }
    const auto wrapped = ossuary::voxel::wrap_points(points, {.min_points = 4, .max_side = 24});
    if (!wrapped) {
        require(wrapped.error().code == ossuary::ErrorCode::kPointsTooFew ||
                wrapped.error().code == ossuary::ErrorCode::kMeshNoExtent);
        return 0;
    }
    require(!wrapped->mesh.empty());
    for (const ossuary::Vec3& vertex : wrapped->mesh.vertices) require(vertex.allFinite());
    const ossuary::mesh::MeshReport report = ossuary::mesh::inspect(wrapped->mesh);
    require(report.boundary_edges == 0);
    return 0;
}
