#include "engine/descriptor/shell_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/descriptor/shape_diameter.h"
#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

TEST(ShellGraph, KeepsTheAreaAndJoinsNeighboursBothWays) {
    const SolidSurface surface = solid_surface(test::torus().volume);
    const ShellGraph graph = shell_graph(surface, 3);
    EXPECT_NEAR(graph.total_area, surface.total_area, 1e-3 * surface.total_area);
    EXPECT_LT(graph.size(), surface.points.size() / 4);
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        for (std::uint32_t e = graph.first_edge[node]; e < graph.first_edge[node + 1]; ++e) {
            const std::uint32_t other = graph.edge_target[e];
            const auto begin = graph.edge_target.begin() + graph.first_edge[other];
            const auto end = graph.edge_target.begin() + graph.first_edge[other + 1];
            EXPECT_NE(std::find(begin, end, node), end);
            EXPECT_GT(graph.edge_length[e], 0.0F);
        }
    }
}

TEST(ShellGraph, MeasuresHalfAGreatCircleOnABall) {
    const ShellGraph graph = shell_graph(solid_surface(test::ball(30.0).volume), 3);
    std::vector<float> distances;
    shortest_distances(graph, 0, distances);
    const float farthest = *std::max_element(distances.begin(), distances.end());
    EXPECT_NEAR(farthest / (std::numbers::pi * 30.0), 1.0, 0.1);
}

TEST(ShellGraph, AveragesAQuarterCircleOnABall) {
    // The mean over the sphere of the distance from any point is a quarter circle.
    const ShellGraph graph = shell_graph(solid_surface(test::ball(30.0).volume), 3);
    for (const float average : average_geodesic_distances(graph, spread_distances(graph, 16), 16)) {
        EXPECT_NEAR(average / (0.5 * std::numbers::pi * 30.0), 1.0, 0.12);
    }
}

TEST(ShellGraph, AveragesMostAtTheEndsOfABar) {
    const voxel::BitVolume volume = test::bar({6, 6, 100}).volume;
    const ShellGraph graph = shell_graph(solid_surface(volume), 3);
    const std::vector<float> average =
        average_geodesic_distances(graph, spread_distances(graph, 16), 16);
    const auto [least, most] = std::minmax_element(average.begin(), average.end());
    // A line of length l averages l / 4 from its middle, l / 2 from its ends.
    EXPECT_NEAR(*most / *least, 2.0, 0.25);
    const auto z_of = [&](auto at) {
        return graph.points[static_cast<std::size_t>(at - average.begin())].z();
    };
    const float middle = static_cast<float>(volume.size().z()) / 2.0F;
    EXPECT_NEAR(z_of(least), middle, 12.0F);
    EXPECT_GT(std::abs(z_of(most) - middle), 40.0F);
}

TEST(ShellGraph, TakesStraightDistancesBetweenPiecesThatDoNotTouch) {
    voxel::BitVolume volume(Vec3i(60, 12, 12));
    for (int x = 2; x < 10; ++x) {
        for (int y = 2; y < 10; ++y) {
            for (int z = 2; z < 10; ++z) volume.set(x, y, z), volume.set(x + 46, y, z);
        }
    }
    const ShellGraph graph = shell_graph(solid_surface(volume), 3);
    for (const float average : average_geodesic_distances(graph, spread_distances(graph, 16), 16)) {
        EXPECT_TRUE(std::isfinite(average));
        EXPECT_GT(average, 20.0F);  // half of all lies 46 voxels off
    }
}

TEST(ShellGraph, CopesWithNothing) {
    const ShellGraph graph = shell_graph({}, 3);
    EXPECT_TRUE(graph.empty());
    EXPECT_TRUE(average_geodesic_distances(graph, spread_distances(graph, 16), 16).empty());
}

TEST(ShapeDiameter, IsThatOfTheBody) {
    // Chords of a ball within 60 degrees of the inward normal, weighted by the cosine: the mean of
    // 2 r cos over the cone, 2 r (int cos^2) / (int cos) = 2 r * 2/3 * (1 - 1/8) / (1 - 1/4).
    const voxel::BitVolume ball = test::ball(24.0).volume;
    const ShellGraph graph = shell_graph(solid_surface(ball), 4);
    for (const float diameter : shape_diameters(graph, ball)) {
        EXPECT_NEAR(diameter / (48.0 * 2.0 / 3.0 * 0.875 / 0.75), 1.0, 0.15);
    }
    // A plate of six voxels: rays meet the other wall after 6 / cos.
    const voxel::BitVolume plate = test::plate({60, 60, 6}).volume;
    const ShellGraph walls = shell_graph(solid_surface(plate), 4);
    std::vector<float> diameters = shape_diameters(walls, plate);
    std::nth_element(diameters.begin(), diameters.begin() + diameters.size() / 2, diameters.end());
    EXPECT_NEAR(diameters[diameters.size() / 2], 7.5F, 1.5F);
}

TEST(ShapeDiameter, IsTheSameOnALongerBar) {
    const voxel::BitVolume volumes[] = {test::bar({8, 8, 60}).volume,
                                        test::bar({8, 8, 120}).volume};
    double means[2];
    for (int i = 0; i < 2; ++i) {
        const ShellGraph graph = shell_graph(solid_surface(volumes[i]), 4);
        const std::vector<float> diameters = shape_diameters(graph, volumes[i]);
        means[i] = std::accumulate(diameters.begin(), diameters.end(), 0.0) /
                   static_cast<double>(diameters.size());
    }
    EXPECT_NEAR(means[0] / means[1], 1.0, 0.12);
}

}  // namespace
}  // namespace ossuary::descriptor
