#include "engine/registration/surface_distance.h"

#include <algorithm>
#include <vector>

namespace ossuary::registration {

OneSidedDistance distance_to(const mesh::TriangleMesh& mesh, const mesh::NearestTriangle& target,
                             const SurfacePoints& source, const Similarity& placement,
                             double tolerance) {
    std::vector<double> distances;
    distances.reserve(source.points.size());
    for (std::size_t i = 0; i < source.points.size(); ++i) {
        const Vec3 point = placement.point(source.points[i]);
        const std::uint32_t triangle = target.of(point, placement.normal(source.normals[i]));
        distances.push_back((mesh::nearest_point_of(mesh.corners(triangle), point) - point).norm());
    }
    std::sort(distances.begin(), distances.end());
    const auto count = static_cast<double>(distances.size());
    OneSidedDistance result;
    for (const double distance : distances) result.mean += distance / count;
    result.most = distances[(distances.size() - 1) * 95 / 100];
    result.greatest = distances.back();
    const auto end = std::upper_bound(distances.begin(), distances.end(), tolerance);
    result.explained = static_cast<double>(end - distances.begin()) / count;
    return result;
}

}  // namespace ossuary::registration
