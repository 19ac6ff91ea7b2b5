#include "engine/registration/piece_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/mesh/nearest_triangle.h"
#include "engine/registration/closest_points.h"
#include "engine/registration/feature_candidates.h"

namespace ossuary::registration {
namespace {

constexpr std::size_t kWholePoints = 8192;
constexpr std::size_t kWholeFeatures = 128;
constexpr std::size_t kPiecePoints = 4096;
constexpr std::size_t kPieceFeatures = 48;
/// Of a sample that is spread the first are, too: so many of them tell what to look at.
constexpr std::size_t kLikenessPiecePoints = 24;
constexpr std::size_t kLikenessWholePoints = 100;
constexpr std::size_t kLikenessFirstRadius = 1;
constexpr std::size_t kChecked = 256;
constexpr std::size_t kRefinedOfPiece = 160;
constexpr std::size_t kRough = 64;
constexpr std::size_t kCandidates = 10;
constexpr std::size_t kMatches = 7;
constexpr std::size_t kPlacesRefined = 2;
constexpr std::size_t kSurfacePoints = 4096;
constexpr std::size_t kSettledOfPiece = 600;
constexpr double kSettledOnSurface = 0.02;  ///< as kOnSurface, of settled places
/// Radii over the root of the area: a whole's lie as near to each other as features that were
/// taken a little too large or small still resemble each other.
constexpr double kWholeRadii[] = {0.09, 0.15};
constexpr double kPieceRadii[] = {0.19, 0.24, 0.3, 0.38, 0.48};
constexpr double kStepsOfDistance = 50.0;
constexpr std::size_t kLeastOthers = 3;
constexpr double kLeastShare = 0.03;
constexpr double kMostShare = 1.2;
constexpr std::size_t kLeftOut = 5;  ///< the farthest one of so many
constexpr double kOnSurface = 0.03;  ///< distances over the placed piece's diagonal count up to it

template <std::size_t N>
std::vector<double> radii_of(const double (&ratios)[N], double area) {
    std::vector<double> radii;
    for (const double ratio : ratios) radii.push_back(ratio * std::sqrt(area));
    return radii;
}

/// Without the farthest fifth.
double mean_of_nearest(std::vector<double>& distances) {
    std::sort(distances.begin(), distances.end());
    const std::size_t counted = distances.size() - distances.size() / kLeftOut;
    double sum = 0.0;
    for (std::size_t i = 0; i < counted; ++i) sum += distances[i];
    return sum / static_cast<double>(counted);
}

struct Fit {
    double distance = 1.0;
    double explained = 0.0;
};

/// How far points of the piece are from the whole's planes, each at most `kOnSurface`, but
/// for the farthest fifth: what closes a cut lies on nothing.
Fit fit_of(const SurfacePoints& points, const WholeSurface& whole, const Similarity& placement) {
    const double most = kOnSurface * points.diagonal * placement.scale;
    std::vector<double> distances;
    std::size_t near = 0;
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const Vec3 moved = placement.point(points.points[i]);
        const NearestPoint::Found found = whole.nearest().of(moved);
        const Vec3& normal = whole.surface().normals[found.index];
        const Vec3 way = moved - whole.surface().points[found.index];
        const double off = std::abs(normal.dot(way));
        // Beside the nearest point's surroundings there is no surface to lie on.
        const double beside =
            std::max(0.0, std::sqrt(std::max(0.0, found.squared_distance - off * off)) -
                              1.5 * std::sqrt(whole.surface().area /
                                              static_cast<double>(whole.surface().points.size())));
        const bool faces = placement.normal(points.normals[i]).dot(normal) > 0.5;
        const double distance = faces ? std::min(most, std::hypot(off, beside)) : most;
        distances.push_back(distance / most);
        if (distance < 0.5 * most) ++near;
    }
    const double distance = mean_of_nearest(distances);
    return {distance, static_cast<double>(near) / static_cast<double>(distances.size())};
}

double distance_from(const mesh::TriangleMesh& mesh, const mesh::NearestTriangle& triangles,
                     const Vec3& point) {
    const auto& corners = mesh.triangles[triangles.of(point, Vec3::Zero())];
    const Vec3 nearest = mesh::nearest_point_of(
        {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]}, point);
    return (nearest - point).norm();
}

}  // namespace

WholeFeatures whole_features(const mesh::TriangleMesh& mesh) {
    const SurfacePoints surface = surface_points(mesh, {.count = kWholePoints});
    if (surface.points.empty()) return {};
    WholeFeatures whole{local_features(surface, NearestPoint(surface.points), kWholeFeatures,
                                       radii_of(kWholeRadii, surface.area)),
                        surface.area};
    for (LocalFeature& feature : whole.features.features) feature = coarse(feature);
    return whole;
}

PieceQuery piece_query(const mesh::TriangleMesh& mesh) {
    PieceQuery piece;
    piece.surface = surface_points(mesh, {.count = kPiecePoints});
    if (piece.surface.points.empty()) return piece;
    piece.features = local_features(piece.surface, NearestPoint(piece.surface.points),
                                    kPieceFeatures, radii_of(kPieceRadii, piece.surface.area));
    piece.checked = thinned_out(piece.surface, kChecked);
    return piece;
}

std::vector<std::uint16_t> nearest_features(const PieceQuery& piece, const WholeFeatures& whole) {
    constexpr int kFarthest = std::numeric_limits<std::uint16_t>::max();
    std::vector<std::uint16_t> nearest;
    const std::size_t points = std::min(kLikenessPiecePoints, piece.features.points.size());
    const std::size_t others =
        std::min(kLikenessWholePoints, whole.features.points.size()) * whole.features.radii.size();
    for (std::size_t p = 0; p < points; ++p) {
        for (std::size_t r = kLikenessFirstRadius; r < piece.features.radii.size(); ++r) {
            int least = std::numeric_limits<int>::max();
            for (std::size_t i = 0; i < others; ++i) {
                least = std::min(
                    least, piece_distance(piece.features.at(p, r), whole.features.features[i]));
            }
            const double distance = kStepsOfDistance * std::sqrt(static_cast<double>(least));
            nearest.push_back(static_cast<std::uint16_t>(std::min<double>(kFarthest, distance)));
        }
    }
    return nearest;
}

std::vector<double> piece_likeness(std::span<const std::vector<std::uint16_t>> nearest) {
    std::vector<double> likeness(nearest.size(), 0.0);
    if (nearest.empty()) return likeness;
    std::vector<std::uint16_t> values(nearest.size());
    const std::size_t others = std::min(nearest.size() - 1, kLeastOthers + nearest.size() / 20);
    for (std::size_t feature = 0; feature < nearest.front().size(); ++feature) {
        for (std::size_t i = 0; i < nearest.size(); ++i) values[i] = nearest[i][feature];
        const auto last = values.begin() + static_cast<std::ptrdiff_t>(others);
        std::nth_element(values.begin(), last, values.end());
        for (std::size_t i = 0; i < nearest.size(); ++i) {
            likeness[i] += std::max(0, *last - nearest[i][feature]);
        }
    }
    const double most = *std::max_element(likeness.begin(), likeness.end());
    for (double& value : likeness) value = most > 0.0 ? value / most : 0.0;
    return likeness;
}

WholeSurface::WholeSurface(const mesh::TriangleMesh& mesh)
    : surface_(surface_points(mesh, {.count = kSurfacePoints})), nearest_(surface_.points) {}

std::optional<PiecePlacement> place_piece(const PieceQuery& piece, const WholeFeatures& whole,
                                          const WholeSurface& surface) {
    if (piece.surface.points.empty() || whole.features.points.empty() || surface.empty()) {
        return std::nullopt;
    }
    const double scale = std::sqrt(whole.area / piece.surface.area);
    FeatureCandidateOptions options;
    options.kind.scale = true;
    options.most = kCandidates;
    options.matches = kMatches;
    options.least_scale = scale * std::sqrt(kLeastShare);
    options.most_scale = scale * std::sqrt(kMostShare);
    const auto candidates =
        feature_candidates(piece.features, whole.features, piece.surface.diagonal, options);
    const SurfacePoints few = thinned_out(piece.surface, kRough);
    std::vector<std::pair<double, Similarity>> starts;
    for (const FeatureCandidate& candidate : candidates) {
        const Refined refined = refine(few, surface.surface(), surface.nearest(),
                                       candidate.placement, {.scale = true, .iterations = 8});
        starts.emplace_back(fit_of(few, surface, refined.placement).distance, refined.placement);
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (starts.size() > kPlacesRefined) starts.resize(kPlacesRefined);
    const SurfacePoints more = thinned_out(piece.surface, kRefinedOfPiece);
    std::optional<PiecePlacement> best;
    for (const auto& [rough, start] : starts) {
        const Refined refined = refine(more, surface.surface(), surface.nearest(), start,
                                       {.scale = true, .iterations = 12, .reach = 0.03});
        const Similarity& placement = refined.placement;
        // Shrunk without end, anything lies on anything.
        if (placement.scale < options.least_scale || placement.scale > options.most_scale) continue;
        const Fit fit = fit_of(piece.checked, surface, placement);
        if (!best || fit.distance < best->distance) {
            best = PiecePlacement{placement, fit.explained, fit.distance};
        }
    }
    return best;
}

PiecePlacement settle_piece(const PieceQuery& piece, const mesh::TriangleMesh& mesh,
                            const PiecePlacement& placed) {
    const SurfacePoints points = thinned_out(piece.surface, kSettledOfPiece);
    const SurfacePoints whole = surface_points(mesh, {.count = 2 * kSurfacePoints});
    PiecePlacement best = placed;
    best.distance = 1.0;
    const mesh::NearestTriangle triangles(mesh);
    const Refined refined = refine(points, whole, NearestPoint(whole.points), placed.placement,
                                   {.scale = true, .iterations = 30, .reach = 0.02});
    for (const Similarity& placement : {placed.placement, refined.placement}) {
        const double change = placement.scale / placed.placement.scale;
        if (change < 0.8 || change > 1.25) continue;
        const double most = kSettledOnSurface * points.diagonal * placement.scale;
        std::vector<double> distances;
        std::size_t near = 0;
        for (const Vec3& point : points.points) {
            const Vec3 moved = placement.point(point);
            const double distance = std::min(most, distance_from(mesh, triangles, moved));
            distances.push_back(distance / most);
            if (distance < 0.5 * most) ++near;
        }
        const double distance = mean_of_nearest(distances);
        if (distance < best.distance) {
            best = {placement, static_cast<double>(near) / static_cast<double>(distances.size()),
                    distance};
        }
    }
    return best;
}

}  // namespace ossuary::registration
