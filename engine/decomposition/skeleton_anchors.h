#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/skeleton/skeleton_graph.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::decomposition {

/// A skeleton as points two steps apart along its branches, and the ways between them.
struct SkeletonSamples {
    struct Point {
        Vec3 position = Vec3::Zero();
        double radius = 0.0;
        std::int32_t branch = -1;  ///< -1 at the skeleton's nodes
        bool junction = false;
    };
    struct Link {
        std::uint32_t to = 0;
        float length = 0.0F;
    };
    std::vector<Point> points;
    std::vector<std::vector<Link>> links;
};
SkeletonSamples sample_skeleton(const skeleton::SkeletonGraph& skeleton);

/// The point of the skeleton that a point of the surface belongs to: near, with the surface facing
/// away from it, and in sight through the solid where one such is.
/// @param point, inside, normal  on the surface, just below it, and unit length outwards
struct SkeletonAnchor {
    std::uint32_t sample = 0;
    double excess = 0.0;  ///< of the distance over 0.7 radii, plus what not facing away costs
};
SkeletonAnchor anchor(const SkeletonSamples& samples, const voxel::BitVolume& solid,
                      const Vec3& point, const Vec3& inside, const Vec3& normal);

/// What the ways along the skeleton from one sample to all others are like; shortest ways.
struct SkeletonWays {
    std::vector<float> length;  ///< infinite where there is none
    std::vector<float> least_radius;
    std::vector<float> largest_radius;
    std::vector<float> junctions;  ///< on the way; half for each end that is one
};
SkeletonWays ways_from(const SkeletonSamples& samples, std::uint32_t source);

/// The share of a straight line that lies outside the solid, looked at about every voxel.
struct Outside {
    float share = 0.0F;
    float length = 0.0F;  ///< voxels
};
Outside outside(const voxel::BitVolume& solid, const Vec3& a, const Vec3& b);

}  // namespace ossuary::decomposition
