#include "engine/descriptor/thickness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/descriptor/body_scale.h"
#include "engine/descriptor/byte_distance.h"
#include "engine/descriptor/shape_diameter.h"
#include "engine/descriptor/solid_surface.h"
#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

struct Build {
    std::vector<std::uint8_t> thickness, pairs;
};

Build build_of(const std::vector<test::Capsule>& limbs) {
    const voxel::BitVolume volume = test::capsule_volume(limbs);
    const SolidSurface surface = solid_surface(volume);
    const double scale = body_scale(surface.total_area, static_cast<double>(volume.count()));
    const ShellGraph graph = shell_graph(surface, 4);
    const std::vector<float> diameters = shape_diameters(graph, volume);
    return {thickness(graph, diameters, scale),
            thickness_pairs(graph, spread_distances(graph, 32), diameters, scale)};
}

/// A thick trunk with two limbs of different girths, bent at the hips by the angles.
std::vector<test::Capsule> body(double first, double second, double girth = 3.0) {
    const Vec3 hips(60.0, 0.0, 0.0);
    return {{Vec3::Zero(), hips, 8.0},
            {hips, hips + 45.0 * Vec3(std::cos(first), std::sin(first), 0.0), girth},
            {hips, hips + 45.0 * Vec3(std::cos(second), 0.0, std::sin(second)), 5.0}};
}

std::uint32_t apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    return byte_distance(a.data(), b.data(), a.size());
}

TEST(Thickness, ChangesWithGirthsAndHardlyWithPose) {
    const Build straight = build_of(body(0.9, -0.9));
    const Build bent = build_of(body(-1.2, 1.3));
    const Build slim = build_of(body(0.9, -0.9, 2.2));
    ASSERT_EQ(straight.thickness.size(), kThicknessSize);
    ASSERT_EQ(straight.pairs.size(), kThicknessPairsSize);
    EXPECT_LT(2 * apart(straight.thickness, bent.thickness),
              apart(straight.thickness, slim.thickness));
    EXPECT_LT(3 * apart(straight.pairs, bent.pairs), 2 * apart(straight.pairs, slim.pairs));
}

TEST(Thickness, PairsTellWhereTheThickPlacesAre) {
    // The same girths along as much length: thick and thin by turns, or each in one piece.
    const auto chain = [](const std::vector<double>& radii) {
        std::vector<test::Capsule> limbs;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const auto at = static_cast<double>(i);
            limbs.push_back(
                {Vec3(30.0 * at, 0.0, 0.0), Vec3(30.0 * at + 20.0, 0.0, 0.0), radii[i]});
            limbs.push_back({Vec3(30.0 * at, 0.0, 0.0), Vec3(30.0 * at + 30.0, 0.0, 0.0), 3.0});
        }
        return build_of(limbs);
    };
    const Build by_turns = chain({7.0, 3.0, 7.0, 3.0}), in_one_piece = chain({7.0, 7.0, 3.0, 3.0});
    EXPECT_GT(apart(by_turns.pairs, in_one_piece.pairs),
              2 * apart(by_turns.thickness, in_one_piece.thickness));
}

TEST(Thickness, IsThatOfAnEmptyGraph) {
    EXPECT_EQ(thickness({}, {}, 1.0), std::vector<std::uint8_t>(kThicknessSize, 0));
    EXPECT_EQ(thickness_pairs({}, {}, {}, 1.0), std::vector<std::uint8_t>(kThicknessPairsSize, 0));
}

}  // namespace
}  // namespace ossuary::descriptor
