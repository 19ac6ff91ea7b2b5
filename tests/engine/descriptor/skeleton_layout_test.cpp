#include "engine/descriptor/skeleton_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/geometry.h"
#include "engine/descriptor/byte_distance.h"

namespace ossuary::descriptor {
namespace {

/// Three limbs of different length from one point, as `transform` lays them; the first two are
/// `angle` apart.
matching::SkeletonDescriptor limbs(double angle, const Mat3& transform = Mat3::Identity()) {
    skeleton::SkeletonGraph graph;
    graph.nodes.push_back({Vec3::Zero(), 0.05, 0.0, 3});
    const Vec3 ends[] = {Vec3(1, 0, 0), 0.7 * Vec3(std::cos(angle), std::sin(angle), 0),
                         Vec3(0, 0.1, 0.5)};
    for (const Vec3& end : ends) {
        const auto node = static_cast<std::uint32_t>(graph.nodes.size());
        graph.nodes.push_back({transform * end, 0.05, 0.0, 1});
        skeleton::SkeletonGraph::Branch branch{0, node, {}, {}};
        for (int step = 0; step <= 20; ++step) {
            branch.points.emplace_back(step / 20.0 * (transform * end));
            branch.radii.push_back(0.05);
        }
        graph.branches.push_back(branch);
    }
    return matching::describe_skeleton(graph, 1.0);
}

std::vector<std::uint8_t> layout(const matching::SkeletonDescriptor& skeleton) {
    return skeleton_layout({&skeleton, 1});
}

std::uint32_t distance(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    return byte_distance(a.data(), b.data(), kSkeletonLayoutSize);
}

TEST(SkeletonLayout, IsFreeOfRotationMirroringAndPosition) {
    const auto original = layout(limbs(0.8));
    const Mat3 turn = Eigen::AngleAxisd(1.3, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
    // Bytes may round differently by one here and there.
    EXPECT_LE(distance(original, layout(limbs(0.8, turn))), 4U);
    EXPECT_LE(distance(original, layout(limbs(0.8, turn * mirror))), 4U);
}

TEST(SkeletonLayout, KnowsThePose) {
    const auto original = layout(limbs(0.8));
    const std::uint32_t little = distance(original, layout(limbs(1.0)));
    const std::uint32_t much = distance(original, layout(limbs(2.4)));
    EXPECT_GT(little, 0U);
    EXPECT_GT(much, 2 * little);
}

/// A short straight limb of this radius, with a stub across its middle or without.
matching::SkeletonDescriptor short_limb(double radius, bool with_stub) {
    skeleton::SkeletonGraph graph;
    graph.nodes.push_back({Vec3::Zero(), radius, 0.0, with_stub ? 3 : 2});
    std::vector<Vec3> ends = {Vec3(0.2, 0, 0), Vec3(-0.2, 0, 0)};
    if (with_stub) ends.emplace_back(0, 0.2, 0);
    for (const Vec3& end : ends) {
        const auto node = static_cast<std::uint32_t>(graph.nodes.size());
        graph.nodes.push_back({end, radius, 0.0, 1});
        graph.branches.push_back({0, node, {Vec3::Zero(), end}, {radius, radius}});
    }
    return matching::describe_skeleton(graph, 1.0);
}

TEST(SkeletonLayout, HeedsAShortBranchLessInAThickBody) {
    const auto stub_tells = [](double radius) {
        return distance(layout(short_limb(radius, false)), layout(short_limb(radius, true)));
    };
    EXPECT_GT(stub_tells(0.02), 0U);
    EXPECT_LT(2 * stub_tells(0.5), stub_tells(0.02));
}

TEST(SkeletonLayout, CopesWithAPointAndWithNothing) {
    const matching::SkeletonDescriptor nothing;
    EXPECT_EQ(layout(nothing), std::vector<std::uint8_t>(kSkeletonLayoutSize, 0));
    EXPECT_EQ(skeleton_layout({}), layout(nothing));
    matching::SkeletonDescriptor point;
    point.nodes.push_back({{}, 0.2F, 0.0F});
    EXPECT_NE(layout(point), layout(nothing));
}

}  // namespace
}  // namespace ossuary::descriptor
