#include "engine/registration/local_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace ossuary::registration {
namespace {

constexpr double kByteOfOne = 110.0;  ///< the byte of a flat shell's whole area
constexpr auto kHeights = LocalFeature::kHeights;
constexpr auto kTurns = LocalFeature::kTurns;

/// All bits where what a piece has more than the whole counts more than what it has less.
constexpr std::array<std::int16_t, LocalFeature::kBytes> kCountsExcess = [] {
    std::array<std::int16_t, LocalFeature::kBytes> masks{};
    for (std::size_t i = 0; i < LocalFeature::kBytes; ++i) {
        masks[i] =
            i % LocalFeature::kPerShell < kHeights + kTurns ? std::int16_t{-1} : std::int16_t{0};
    }
    return masks;
}();

std::vector<std::uint32_t> spread(const std::vector<Vec3>& points, std::size_t count) {
    std::vector<std::uint32_t> chosen;
    if (points.empty()) return chosen;
    std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
    std::uint32_t next = 0;
    while (chosen.size() < std::min(count, points.size())) {
        chosen.push_back(next);
        const Vec3 last = points[next];
        double farthest = -1.0;
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            distance[i] = std::min(distance[i], (points[i] - last).squaredNorm());
            if (distance[i] > farthest) {
                farthest = distance[i];
                next = i;
            }
        }
    }
    return chosen;
}

constexpr double kSmoothed = 0.4;  ///< of the radius: normals so near make the feature's own

/// A neighbour of a feature's point.
struct Neighbor {
    double distance = 0.0;
    double height = 0.0;              ///< sine of the angle above the tangent plane
    double turn = 0.0;                ///< cosine of the angle between normals
    double cosine = 0.0, sine = 0.0;  ///< of the azimuth
};

/// The mean normal near the point, of what faces its way: that of one triangle says little where
/// triangles are large.
Vec3 smoothed_normal(const SurfacePoints& surface, const std::vector<NearestPoint::Found>& found,
                     std::uint32_t center, double radius) {
    Vec3 sum = surface.normals[center];
    for (const NearestPoint::Found& each : found) {
        const double far = each.squared_distance / (kSmoothed * kSmoothed * radius * radius);
        const Vec3& normal = surface.normals[each.index];
        if (far < 1.0 && normal.dot(surface.normals[center]) > 0.0) sum += (1.0 - far) * normal;
    }
    return sum.normalized();
}

using Sums = std::array<std::array<double, LocalFeature::kPerShell + LocalFeature::kHarmonics>,
                        LocalFeature::kShells>;

/// Adds `weight` to the two bins of `count` over [-1, 1] that `value` lies between.
void add_between(double* bins, std::size_t count, double value, double weight) {
    const double place =
        0.5 * (std::clamp(value, -1.0, 1.0) + 1.0) * static_cast<double>(count - 1);
    const auto low = std::min(static_cast<std::size_t>(place), count - 2);
    const double share = place - static_cast<double>(low);
    bins[low] += weight * (1.0 - share);
    bins[low + 1] += weight * share;
}

void add(Sums& sums, std::size_t shell, const Neighbor& neighbor, double weight) {
    auto& bins = sums[shell];
    add_between(bins.data(), kHeights, neighbor.height, weight);
    add_between(bins.data() + kHeights, kTurns, neighbor.turn, weight);
    double* harmonics = bins.data() + kHeights + kTurns;
    harmonics[0] += weight * neighbor.cosine;
    harmonics[1] += weight * neighbor.sine;
    harmonics[2] += weight * (neighbor.cosine * neighbor.cosine - neighbor.sine * neighbor.sine);
    harmonics[3] += weight * 2.0 * neighbor.cosine * neighbor.sine;
}

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(std::clamp(kByteOfOne * std::sqrt(share), 0.0, 255.0));
}

/// @param flat  how many points a flat surface has in a shell
LocalFeature feature_of(std::span<const Neighbor> neighbors, double radius, double flat) {
    Sums sums{};
    for (const Neighbor& neighbor : neighbors) {
        const double ratio = neighbor.distance / radius;
        // Shells overlap by half, and the outermost fades out towards the ball's end.
        const double place = ratio * ratio * LocalFeature::kShells - 0.5;
        const double low = std::floor(place);
        const double share = place - low;
        const auto shell = static_cast<int>(low);
        if (shell >= 0) add(sums, static_cast<std::size_t>(shell), neighbor, 1.0 - share);
        if (shell < 0) add(sums, 0, neighbor, 1.0 - share);
        if (shell + 1 < static_cast<int>(LocalFeature::kShells)) {
            add(sums, static_cast<std::size_t>(shell + 1), neighbor, share);
        }
    }
    LocalFeature feature;
    auto value = feature.values.begin();
    for (const auto& bins : sums) {
        for (std::size_t bin = 0; bin < kHeights + kTurns; ++bin) {
            *value++ = byte_of(bins[bin] / flat);
        }
        const double* harmonics = bins.data() + kHeights + kTurns;
        *value++ = byte_of(std::hypot(harmonics[0], harmonics[1]) / flat);
        *value++ = byte_of(std::hypot(harmonics[2], harmonics[3]) / flat);
    }
    return feature;
}

std::vector<Neighbor> neighbors_of(const SurfacePoints& surface,
                                   const std::vector<NearestPoint::Found>& found,
                                   std::uint32_t center, const Vec3& normal, double radius) {
    const Vec3& point = surface.points[center];
    const Vec3 across = normal.unitOrthogonal();
    const Vec3 along = normal.cross(across);
    std::vector<Neighbor> neighbors;
    neighbors.reserve(found.size());
    for (const NearestPoint::Found& each : found) {
        if (each.squared_distance >= radius * radius) continue;
        const Vec3 way = surface.points[each.index] - point;
        Neighbor neighbor;
        neighbor.distance = std::sqrt(each.squared_distance);
        neighbor.turn = normal.dot(surface.normals[each.index]);
        if (neighbor.distance > 0.0) neighbor.height = normal.dot(way) / neighbor.distance;
        const double x = across.dot(way);
        const double y = along.dot(way);
        const double length = std::hypot(x, y);
        if (length > 0.0) {
            neighbor.cosine = x / length;
            neighbor.sine = y / length;
        }
        neighbors.push_back(neighbor);
    }
    return neighbors;
}

}  // namespace

LocalFeature coarse(const LocalFeature& feature) {
    LocalFeature other;
    for (std::size_t i = 0; i < LocalFeature::kBytes; ++i) {
        const int level = (feature.values[i] + LocalFeature::kStep / 2) / LocalFeature::kStep;
        other.values[i] = static_cast<std::uint8_t>(std::min<int>(level, LocalFeature::kMostLevel) *
                                                    LocalFeature::kStep);
    }
    return other;
}

LocalFeature turned_over(const LocalFeature& feature) {
    LocalFeature other = feature;
    for (std::size_t shell = 0; shell < LocalFeature::kShells; ++shell) {
        const auto first =
            other.values.begin() + static_cast<std::ptrdiff_t>(shell * LocalFeature::kPerShell);
        std::reverse(first, first + static_cast<std::ptrdiff_t>(kHeights));
    }
    return other;
}

int squared_distance(const LocalFeature& a, const LocalFeature& b) {
    int sum = 0;
    for (std::size_t i = 0; i < LocalFeature::kBytes; ++i) {
        const int difference = static_cast<int>(a.values[i]) - static_cast<int>(b.values[i]);
        sum += difference * difference;
    }
    return sum;
}

int piece_distance(const LocalFeature& piece, const LocalFeature& whole) {
    // Without branches, so that it is done for many values at once.
    int more = 0;
    int all = 0;
    for (std::size_t i = 0; i < LocalFeature::kBytes; ++i) {
        const auto difference = static_cast<std::int16_t>(piece.values[i] - whole.values[i]);
        const auto excess =
            static_cast<std::int16_t>(std::max<std::int16_t>(difference, 0) & kCountsExcess[i]);
        more += excess * excess;
        all += difference * difference;
    }
    return more + (all - more) / 5;
}

LocalFeatures local_features(const SurfacePoints& surface, const NearestPoint& nearest,
                             std::size_t count, std::vector<double> radii) {
    LocalFeatures result;
    result.radii = std::move(radii);
    if (result.radii.empty() || surface.points.empty()) return result;
    const double density = static_cast<double>(surface.points.size()) / surface.area;
    std::vector<NearestPoint::Found> found;
    for (const std::uint32_t center : spread(surface.points, count)) {
        result.points.push_back(surface.points[center]);
        result.normals.push_back(surface.normals[center]);
        nearest.within(surface.points[center], result.radii.back(), found);
        for (const double radius : result.radii) {
            const Vec3 normal = smoothed_normal(surface, found, center, radius);
            const std::vector<Neighbor> neighbors =
                neighbors_of(surface, found, center, normal, radius);
            const double flat =
                density * std::numbers::pi * radius * radius / LocalFeature::kShells;
            result.features.push_back(feature_of(neighbors, radius, flat));
        }
    }
    return result;
}

}  // namespace ossuary::registration
