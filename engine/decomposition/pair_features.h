#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/decomposition/patches.h"
#include "engine/skeleton/skeletonize.h"

namespace ossuary::decomposition {

/// What is measured of two patches to tell whether they belong to one part. Lengths are over the
/// square root of the area; "log" is the natural logarithm, log1p(x) = log(1 + x).
enum class PairFeature : std::size_t {
    kThicknessLeast,  ///< the smaller logarithm of the shape diameter
    kThicknessMost,   ///< the larger one
    kThicknessNeck,   ///< by how much every way between them gets thinner than both (logarithm)
    kThicknessBulge,  ///< by how much every way between them gets thicker than both (logarithm)
    kThicknessStep,   ///< the largest step of the logarithm on the way that keeps it smallest
    kDistance,        ///< log1p of the straight distance
    kGeodesic,        ///< log1p of the distance along the surface
    kDetour,          ///< log of geodesic over straight distance, both plus .05
    kConcaveWay,      ///< log1p of the concave turns on the least concave way, plus .02 its length
    kConcaveDensity,  ///< the same sum over the geodesic distance plus .3
    kConcaveBarrier,  ///< the largest concave turn between patches on the way that keeps it
                      ///< smallest
    kCreaseBarrier,   ///< the same with the mean turn along the border of two patches
    kResistance,      ///< log1p of the surface's electrical resistance between them
    kResistanceFar,   ///< the same less what the two patches' own borders contribute
    kCreaseResistance,     ///< as kResistance where concave borders conduct less
    kCreaseResistanceFar,  ///< as kResistanceFar where concave borders conduct less
    kOutsideMiddle,        ///< share of the line between the points half a diameter inside that is
                           ///< outside
    kOutsideNear,          ///< the same between points just inside
    kOutsideLength,        ///< log1p of five times the length outside of the latter
    kSkeletonWay,          ///< length of the way along the skeleton, at most 5
    kSkeletonNeck,         ///< log of the least radius on it over the smaller of the ends'
    kSkeletonBulge,        ///< log of the largest radius on it over the larger of the ends'
    kSkeletonJunctions,    ///< junctions on it; ends count half
    kSameBranch,           ///< 1 when both are nearest to one branch
    kRadiusLeast,          ///< the smaller logarithm of the radius of the skeleton at the two
    kRadiusMost,
    kReachLeast,  ///< the smaller excess of the distance from the skeleton over its radius
    kReachMost,
    kCentralityLeast,  ///< the smaller mean geodesic distance to the whole surface
    kCentralityMost,
    kNormals,  ///< cosine between the normals
};
inline constexpr std::size_t kPairFeatureCount = 31;
using PairFeatures = std::array<float, kPairFeatureCount>;

/// Something of each feature, in the order of the enumeration.
template <typename T>
struct OfPairFeature {
    PairFeature feature;
    T value;
};
template <typename T>
using OfPairFeatures = std::array<OfPairFeature<T>, kPairFeatureCount>;
template <typename T>
consteval bool in_order(const OfPairFeatures<T>& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (static_cast<std::size_t>(rows[k].feature) != k) return false;
    }
    return true;
}

struct PatchPairs {
    std::size_t patches = 0;
    /// Of the pairs (0, 1), (0, 2), (1, 2), (0, 3) …: pair (i, j), i < j, is at j (j - 1) / 2 + i.
    std::vector<PairFeatures> features;
    std::vector<std::int32_t> branch_of_patch;  ///< of the refined skeleton; -1 at nodes

    [[nodiscard]] static std::size_t index(std::size_t i, std::size_t j) {
        return i < j ? j * (j - 1) / 2 + i : i * (i - 1) / 2 + j;
    }
};

/// Measures every pair of patches. About 12,000 pairs of 160 patches take some 15 ms.
/// @param skeleton  of the same model, with the solid's volume
PatchPairs pair_features(const SurfaceGraph& surface, const PatchGraph& graph,
                         const skeleton::Skeleton& skeleton, const std::stop_token& stop = {});

}  // namespace ossuary::decomposition
