#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/registration/surface_points.h"

namespace ossuary::registration {

/// What a surface looks like around one of its points, within a ball: blind to turns and to
/// position, and to scale where the ball grows with the surface. Shells of equal flat area around
/// the point, and in each how far the surface there lies above or below the tangent plane, how its
/// normals turn away, and how one-sided and how two-sided it is about the normal (the first two
/// harmonics of the azimuth, by magnitude). Mirrored surfaces have equal ones.
struct LocalFeature {
    static constexpr std::size_t kShells = 4;
    static constexpr std::size_t kHeights = 5;
    static constexpr std::size_t kTurns = 4;
    static constexpr std::size_t kHarmonics = 2;
    static constexpr std::size_t kPerShell = kHeights + kTurns + kHarmonics;
    static constexpr std::size_t kBytes = kShells * kPerShell;

    /// Coarse values are multiples of kStep, at most kStep * kMostLevel: half a byte each.
    static constexpr std::uint8_t kStep = 9;
    static constexpr std::uint8_t kMostLevel = 15;

    /// Roots of shares of a flat shell's area, so that rare and common count alike.
    std::array<std::uint8_t, kBytes> values{};
};

struct LocalFeatures {
    std::vector<Vec3> points, normals;   ///< where they are; model units
    std::vector<double> radii;           ///< of the balls, ascending, model units
    std::vector<LocalFeature> features;  ///< of point p and radius r at p * radii.size() + r

    [[nodiscard]] const LocalFeature& at(std::size_t point, std::size_t radius) const {
        return features[point * radii.size() + radius];
    }
};

/// With coarse values, as they are kept.
[[nodiscard]] LocalFeature coarse(const LocalFeature& feature);

/// That of the surface seen from the other side.
[[nodiscard]] LocalFeature turned_over(const LocalFeature& feature);

/// Squared Euclidean distance of two features' bytes.
[[nodiscard]] int squared_distance(const LocalFeature& a, const LocalFeature& b);

/// How far the surroundings of a piece's point are from being part of those of a whole's point:
/// what the whole has more counts a fifth, since the piece ends somewhere, and so do harmonics,
/// which that changes too.
[[nodiscard]] int piece_distance(const LocalFeature& piece, const LocalFeature& whole);

/// Features at `count` points that are spread as far from each other as they can be (farthest
/// point sampling), for each of the radii (ascending, model units). Deterministic.
[[nodiscard]] LocalFeatures local_features(const SurfacePoints& surface,
                                           const NearestPoint& nearest, std::size_t count,
                                           std::vector<double> radii);

}  // namespace ossuary::registration
