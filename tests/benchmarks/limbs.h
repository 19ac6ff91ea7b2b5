#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/skeleton/skeleton_graph.h"

/// Limbs of bodies, and which of one body's is which of another's; for posed copies.
namespace ossuary::benchmarks {

struct Limb {
    std::uint32_t branch = 0;  ///< of the skeleton
    bool from_a = true;        ///< the body is at the branch's node a
    std::uint32_t second = 0;  ///< branch of the split skeleton: the outer half
    Vec3 root, middle, tip;
};

/// A branch with one free end as a limb; none otherwise.
[[nodiscard]] std::optional<Limb> limb_of(const skeleton::SkeletonGraph& skeleton,
                                          std::uint32_t branch);

/// The branches with a free end that are at least a quarter as long as the longest of all.
[[nodiscard]] std::vector<std::uint32_t> limbs_of(const skeleton::SkeletonGraph& skeleton);

/// The limb's outer half becomes a branch of its own, `limb.second`.
void split_limb(skeleton::SkeletonGraph& graph, Limb& limb);

/// The limbs of a body with where they begin and end from the middle of them all, over their size.
struct LimbPlaces {
    std::vector<Limb> limbs;
    std::vector<Vec3> places;  ///< root, tip, root, tip …

    LimbPlaces(const skeleton::SkeletonGraph& skeleton, const std::vector<std::uint32_t>& branches);
};

/// Which of the first body's limbs is which of the other's in a frame, and how far they are apart.
struct LimbMatch {
    Mat3 frame = Mat3::Identity();
    std::vector<std::uint32_t> partner;  ///< of the one with fewer limbs
    double cost = std::numeric_limits<double>::infinity();
};

/// The best of many frames to begin with, each settled: left and right are told apart by where
/// limbs are, which trees of limbs cannot tell. @pre as many limbs or more in `many`
[[nodiscard]] LimbMatch match_places(const LimbPlaces& few, const LimbPlaces& many);

}  // namespace ossuary::benchmarks
