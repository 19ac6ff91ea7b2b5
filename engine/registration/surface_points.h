#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::registration {

/// A surface as points spread evenly over its area.
struct SurfacePoints {
    std::vector<Vec3> points;    ///< model units
    std::vector<Vec3> normals;   ///< one a point, unit length, outwards (mesh::mend_surface)
    double area = 0.0;           ///< of the surface
    double diagonal = 0.0;       ///< of its box
    Vec3 center = Vec3::Zero();  ///< of the area
};

struct SurfacePointsOptions {
    std::size_t count = 4096;
    std::uint64_t seed = 1;
};

/// Area-weighted and stratified (sample_surface.h); the same for the same seed. No points for a
/// mesh without area, or with more than numbers can hold.
[[nodiscard]] SurfacePoints surface_points(const mesh::TriangleMesh& mesh,
                                           const SurfacePointsOptions& options = {});

/// Every so many of the points, at most `count`, with the measures of the whole.
[[nodiscard]] SurfacePoints thinned_out(const SurfacePoints& surface, std::size_t count);

/// Finds the nearest of points, of which it keeps a copy.
class NearestPoint {
public:
    struct Found {
        std::uint32_t index = 0;
        double squared_distance = 0.0;
    };

    explicit NearestPoint(const std::vector<Vec3>& points);
    NearestPoint(NearestPoint&&) noexcept;
    NearestPoint& operator=(NearestPoint&&) noexcept;
    ~NearestPoint();

    /// @pre there are points
    [[nodiscard]] Found of(const Vec3& point) const;
    /// All within `radius`, in the order of their indices.
    void within(const Vec3& point, double radius, std::vector<Found>& found) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace ossuary::registration
