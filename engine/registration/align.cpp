#include "engine/registration/align.h"

#include <algorithm>
#include <cmath>

#include "engine/registration/closest_points.h"
#include "engine/registration/feature_candidates.h"

namespace ossuary::registration {
namespace {

constexpr double kTolerance = 0.005;  ///< of the diagonal: explained
constexpr std::size_t kRoughPoints = 96;
constexpr std::size_t kRefinedPoints = 600;
constexpr std::size_t kFinalists = 4;
constexpr double kGood = 0.01;  ///< mean distance over the diagonal that asks for no other way
constexpr std::size_t kFeaturePoints = 100;

/// Mean distance of points both ways, over the target's diagonal, each held below a tenth.
double rough_distance(const SurfacePoints& source, const SurfacePoints& target,
                      const Shape& source_shape, const Shape& target_shape,
                      const Similarity& placement) {
    const double diagonal = target_shape.surface().diagonal;
    const Similarity back = placement.inverse();
    double sum = 0.0;
    const auto add = [&](double squared, double scale) {
        sum += std::min(0.1, std::sqrt(squared) * scale / diagonal);
    };
    for (const Vec3& point : source.points) {
        add(target_shape.nearest().of(placement.point(point)).squared_distance, 1.0);
    }
    for (const Vec3& point : target.points) {
        add(source_shape.nearest().of(back.point(point)).squared_distance, placement.scale);
    }
    return sum / static_cast<double>(source.points.size() + target.points.size());
}

LocalFeatures whole_features(const Shape& shape) {
    const double size = std::sqrt(shape.surface().area);
    return local_features(shape.surface(), shape.nearest(), kFeaturePoints,
                          {0.15 * size, 0.25 * size});
}

struct Found {
    Similarity placement;
    double distance = 1.0;
};

/// The best of the starts, refined.
Found best_of(const Shape& source, const Shape& target, std::vector<Similarity> starts,
              const MotionKind& kind) {
    const SurfacePoints rough_source = thinned_out(source.surface(), kRoughPoints);
    const SurfacePoints rough_target = thinned_out(target.surface(), kRoughPoints);
    const auto distance = [&](const Similarity& placement) {
        return rough_distance(rough_source, rough_target, source, target, placement);
    };
    std::vector<Found> found;
    found.reserve(starts.size());
    for (const Similarity& start : starts) found.push_back({start, distance(start)});
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.distance < b.distance; });
    if (found.size() > kFinalists) found.resize(kFinalists);
    const SurfacePoints points = thinned_out(source.surface(), kRefinedPoints);
    Found best;
    for (const Found& each : found) {
        const Refined refined = refine(points, target.surface(), target.nearest(), each.placement,
                                       {.scale = kind.scale});
        const double after = distance(refined.placement);
        if (after < best.distance) best = {refined.placement, after};
    }
    return best;
}

}  // namespace

Shape::Shape(const mesh::TriangleMesh& mesh, const SurfacePointsOptions& options)
    : mesh_(&mesh),
      surface_(surface_points(mesh, options)),
      nearest_(surface_.points),
      triangles_(mesh) {}

SurfaceAgreement agreement(const Shape& source, const Shape& target, const Similarity& placement) {
    const double diagonal = target.surface().diagonal;
    const double tolerance = kTolerance * diagonal;
    const OneSidedDistance there =
        distance_to(target.mesh(), target.triangles(), source.surface(), placement, tolerance);
    const OneSidedDistance back = distance_to(source.mesh(), source.triangles(), target.surface(),
                                              placement.inverse(), tolerance / placement.scale);
    const auto share = [&](double forwards, double backwards) {
        return 100.0 * std::max(forwards, backwards * placement.scale) / diagonal;
    };
    return {share(there.mean, back.mean), share(there.most, back.most),
            share(there.greatest, back.greatest), there.explained, back.explained};
}

Alignment align(const Shape& source, const Shape& target, const MotionKind& kind) {
    Found best =
        best_of(source, target, axis_candidates(source.surface(), target.surface(), kind), kind);
    if (best.distance > kGood) {
        std::vector<Similarity> starts;
        for (const FeatureCandidate& candidate :
             feature_candidates(whole_features(source), whole_features(target),
                                source.surface().diagonal, {.kind = kind})) {
            starts.push_back(candidate.placement);
        }
        const Found other = best_of(source, target, std::move(starts), kind);
        if (other.distance < best.distance) best = other;
    }
    return {best.placement, agreement(source, target, best.placement)};
}

}  // namespace ossuary::registration
