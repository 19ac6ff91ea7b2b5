#include "engine/decomposition/skeleton_anchors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/core/shortest_ways.h"

namespace ossuary::decomposition {
namespace {

constexpr double kRadiusShare = 0.7;
constexpr double kFacing = 0.3;       // the cosine from which on a surface faces away enough
constexpr double kFacingCost = 1.5;   // of each unit that is missing, in distances
constexpr float kMaxOutside = 0.25F;  // of the line of sight

}  // namespace

SkeletonSamples sample_skeleton(const skeleton::SkeletonGraph& skeleton) {
    SkeletonSamples samples;
    const auto add = [&](const Vec3& position, double radius, std::int32_t branch, bool junction) {
        samples.points.push_back({position, radius, branch, junction});
        samples.links.emplace_back();
        return static_cast<std::uint32_t>(samples.points.size() - 1);
    };
    const auto link = [&](std::uint32_t a, std::uint32_t b) {
        const auto length =
            static_cast<float>((samples.points[a].position - samples.points[b].position).norm());
        samples.links[a].push_back({b, length});
        samples.links[b].push_back({a, length});
    };
    for (const auto& node : skeleton.nodes) add(node.position, node.radius, -1, node.degree > 2);
    for (std::size_t b = 0; b < skeleton.branches.size(); ++b) {
        const auto& branch = skeleton.branches[b];
        std::uint32_t previous = branch.a;
        for (std::size_t k = 2; k + 1 < branch.points.size(); k += 2) {
            const std::uint32_t point =
                add(branch.points[k], branch.radii[k], static_cast<std::int32_t>(b), false);
            link(previous, point);
            previous = point;
        }
        link(previous, branch.b);
    }
    return samples;
}

Outside outside(const voxel::BitVolume& solid, const Vec3& a, const Vec3& b) {
    constexpr float kOne = 65536.0F;
    const float length = static_cast<float>((b - a).norm());
    const int steps = std::max(2, static_cast<int>(length));
    Vec3i at = (kOne * a.cast<float>()).array().floor().cast<std::int32_t>();
    const Vec3i step =
        (kOne / static_cast<float>(steps) * (b - a).cast<float>()).cast<std::int32_t>();
    int out = 0;
    for (int k = 0; k <= steps; ++k, at += step) {
        if (!solid.test_or_false({at.x() >> 16, at.y() >> 16, at.z() >> 16})) ++out;
    }
    const float share = static_cast<float>(out) / static_cast<float>(steps + 1);
    return {share, share * length};
}

SkeletonAnchor anchor(const SkeletonSamples& samples, const voxel::BitVolume& solid,
                      const Vec3& point, const Vec3& inside, const Vec3& normal) {
    SkeletonAnchor best{0, std::numeric_limits<double>::infinity()};
    for (std::uint32_t s = 0; s < samples.points.size(); ++s) {
        const Vec3 away = point - samples.points[s].position;
        const double distance = away.norm();
        double excess = distance - kRadiusShare * samples.points[s].radius;
        if (excess >= best.excess) continue;
        const double facing = distance > 1e-9 ? away.dot(normal) / distance : 1.0;
        if (facing < kFacing) excess += kFacingCost * (kFacing - facing) * distance;
        if (excess >= best.excess) continue;
        if (outside(solid, samples.points[s].position, inside).share > kMaxOutside) {
            excess += distance;
        }
        if (excess < best.excess) best = {s, excess};
    }
    return best;
}

SkeletonWays ways_from(const SkeletonSamples& samples, std::uint32_t source) {
    constexpr float kUnreached = std::numeric_limits<float>::infinity();
    const std::size_t count = samples.points.size();
    const auto half = [&](std::uint32_t s) { return samples.points[s].junction ? 0.5F : 0.0F; };
    const auto radius = [&](std::uint32_t s) {
        return static_cast<float>(samples.points[s].radius);
    };
    SkeletonWays ways{std::vector<float>(count, kUnreached), std::vector<float>(count, 0.0F),
                      std::vector<float>(count, 0.0F), std::vector<float>(count, 0.0F)};
    ways.length[source] = 0.0F;
    ways.least_radius[source] = ways.largest_radius[source] = radius(source);
    ways.junctions[source] = half(source);
    const auto links = [&](std::uint32_t s, const auto& reach) {
        for (const SkeletonSamples::Link& link : samples.links[s]) {
            if (!reach(link.to, ways.length[s] + link.length)) continue;
            ways.least_radius[link.to] = std::min(ways.least_radius[s], radius(link.to));
            ways.largest_radius[link.to] = std::max(ways.largest_radius[s], radius(link.to));
            ways.junctions[link.to] = ways.junctions[s] + half(s) + half(link.to);
        }
    };
    ShortestWays<float>().search(ways.length, std::span(&source, 1), links);
    return ways;
}

}  // namespace ossuary::decomposition
