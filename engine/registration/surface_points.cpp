#include "engine/registration/surface_points.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>
#include <utility>

#include "engine/mesh/measures.h"
#include "engine/mesh/mend_surface.h"
#include "engine/mesh/sample_surface.h"
#include "engine/voxel/point_set.h"

namespace ossuary::registration {

SurfacePoints surface_points(const mesh::TriangleMesh& mesh, const SurfacePointsOptions& options) {
    const mesh::TriangleMesh outwards = mesh::mend_surface(mesh).mesh;
    const mesh::MeshMeasures measures = mesh::measure(outwards);
    SurfacePoints surface;
    surface.area = measures.surface_area;
    surface.diagonal = measures.diagonal;
    surface.center = measures.area_centroid;
    if (!std::isfinite(surface.area) || !surface.center.allFinite()) return surface;
    const auto samples =
        mesh::sample_surface(outwards, {.count = options.count, .seed = options.seed});
    surface.points.reserve(samples.size());
    surface.normals.reserve(samples.size());
    for (const mesh::SurfaceSample& sample : samples) {
        surface.points.push_back(sample.point);
        surface.normals.push_back(sample.normal);
    }
    return surface;
}

SurfacePoints thinned_out(const SurfacePoints& surface, std::size_t count) {
    SurfacePoints thin{{}, {}, surface.area, surface.diagonal, surface.center};
    const std::size_t kept = std::min(count, surface.points.size());
    for (std::size_t i = 0; i < kept; ++i) {
        const std::size_t at = i * surface.points.size() / kept;
        thin.points.push_back(surface.points[at]);
        thin.normals.push_back(surface.normals[at]);
    }
    return thin;
}

struct NearestPoint::Tree {
    explicit Tree(const std::vector<Vec3>& points) : kept(points), set{kept}, index(3, set, {16}) {}

    std::vector<Vec3> kept;
    voxel::PointSet set;
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, voxel::PointSet>,
                                        voxel::PointSet, 3, std::uint32_t>
        index;
};

NearestPoint::NearestPoint(const std::vector<Vec3>& points)
    : tree_(std::make_unique<Tree>(points)) {}
NearestPoint::NearestPoint(NearestPoint&&) noexcept = default;
NearestPoint& NearestPoint::operator=(NearestPoint&&) noexcept = default;
NearestPoint::~NearestPoint() = default;

NearestPoint::Found NearestPoint::of(const Vec3& point) const {
    Found found;
    tree_->index.knnSearch(point.data(), 1, &found.index, &found.squared_distance);
    return found;
}

void NearestPoint::within(const Vec3& point, double radius, std::vector<Found>& found) const {
    std::vector<std::pair<std::uint32_t, double>> hits;
    nanoflann::SearchParams any_order;
    any_order.sorted = false;
    tree_->index.radiusSearch(point.data(), radius * radius, hits, any_order);
    std::sort(hits.begin(), hits.end());
    found.clear();
    for (const auto& [index, squared] : hits) found.push_back({index, squared});
}

}  // namespace ossuary::registration
