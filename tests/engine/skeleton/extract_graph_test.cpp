#include "engine/skeleton/extract_graph.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/skeleton/thinning.h"
#include "engine/voxel/betti.h"
#include "tests/support/shapes.h"

namespace ossuary::skeleton {
namespace {

SkeletonGraph graph_of(const voxel::BitVolume& skeleton) {
    return extract_graph(skeleton, voxel::distance_transform(skeleton));
}

voxel::BitVolume voxels(const Vec3i& size, const std::vector<Vec3i>& set) {
    voxel::BitVolume volume(size);
    for (const Vec3i& v : set) volume.set(v);
    return volume;
}

/// Draws a lattice line of unit width, its ends included.
void draw(voxel::BitVolume& volume, const Vec3i& from, const Vec3i& to) {
    const int steps = (to - from).cwiseAbs().maxCoeff();
    for (int i = 0; i <= steps; ++i) {
        volume.set(from + ((to - from).cast<double>() * i / std::max(steps, 1))
                              .array()
                              .round()
                              .matrix()
                              .cast<int>());
    }
}

void expect_well_formed(const SkeletonGraph& graph) {
    SkeletonGraph counted = graph;
    update_degrees(counted);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        EXPECT_EQ(graph.nodes[i].degree, counted.nodes[i].degree);
    }
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        ASSERT_LT(branch.a, graph.nodes.size());
        ASSERT_LT(branch.b, graph.nodes.size());
        ASSERT_GE(branch.points.size(), 2u);
        ASSERT_EQ(branch.points.size(), branch.radii.size());
        EXPECT_EQ(branch.points.front(), graph.nodes[branch.a].position);
        EXPECT_EQ(branch.points.back(), graph.nodes[branch.b].position);
        EXPECT_EQ(branch.radii.front(), graph.nodes[branch.a].radius);
        EXPECT_EQ(branch.radii.back(), graph.nodes[branch.b].radius);
    }
}

TEST(ExtractGraph, MakesNothingOfAnEmptyVolume) {
    EXPECT_TRUE(graph_of(voxel::BitVolume(Vec3i(4, 4, 4))).empty());
    EXPECT_TRUE(graph_of(voxel::BitVolume()).empty());
}

TEST(ExtractGraph, MakesANodeOfAnIsolatedVoxel) {
    const SkeletonGraph graph = graph_of(voxels({5, 5, 5}, {{1, 2, 3}}));
    ASSERT_EQ(graph.nodes.size(), 1u);
    EXPECT_EQ(graph.nodes[0].degree, 0);
    EXPECT_EQ(graph.nodes[0].position, Vec3(1.5, 2.5, 3.5));
    EXPECT_EQ(graph.nodes[0].radius, 1.0);
    EXPECT_TRUE(graph.branches.empty());
}

TEST(ExtractGraph, MakesOneBranchOfALine) {
    for (int length = 2; length < 12; ++length) {
        voxel::BitVolume line(Vec3i(20, 5, 5));
        draw(line, {3, 2, 2}, {2 + length, 2, 2});
        const SkeletonGraph graph = graph_of(line);
        ASSERT_EQ(graph.nodes.size(), 2u) << length;
        ASSERT_EQ(graph.branches.size(), 1u) << length;
        EXPECT_EQ(graph.branches[0].points.size(), static_cast<std::size_t>(length));
        EXPECT_DOUBLE_EQ(graph.branches[0].length(), length - 1.0);
        expect_well_formed(graph);
    }
}

TEST(ExtractGraph, MakesAJunctionOfTouchingJunctionVoxelsAtTheirCentreOfGravity) {
    voxel::BitVolume cross(Vec3i(21, 21, 3));
    draw(cross, {0, 10, 1}, {20, 10, 1});
    draw(cross, {10, 0, 1}, {10, 20, 1});
    const SkeletonGraph graph = graph_of(cross);
    ASSERT_EQ(graph.nodes.size(), 5u);
    EXPECT_EQ(graph.branches.size(), 4u);
    int junctions = 0;
    for (const SkeletonGraph::Node& node : graph.nodes) {
        if (node.degree != 4) continue;
        ++junctions;
        EXPECT_LT((node.position - Vec3(10.5, 10.5, 1.5)).norm(), 1e-12);
    }
    EXPECT_EQ(junctions, 1);
    expect_well_formed(graph);
}

TEST(ExtractGraph, GivesAClosedCurveOneNodeOfDegreeTwo) {
    voxel::BitVolume ring(Vec3i(24, 24, 3));
    draw(ring, {8, 2, 1}, {15, 2, 1});
    draw(ring, {16, 3, 1}, {20, 7, 1});
    draw(ring, {20, 8, 1}, {16, 12, 1});
    draw(ring, {15, 13, 1}, {8, 13, 1});
    draw(ring, {7, 12, 1}, {3, 8, 1});
    draw(ring, {3, 7, 1}, {7, 3, 1});
    const SkeletonGraph graph = graph_of(ring);
    ASSERT_EQ(graph.nodes.size(), 1u);
    ASSERT_EQ(graph.branches.size(), 1u);
    EXPECT_EQ(graph.nodes[0].degree, 2);
    EXPECT_EQ(graph.branches[0].points.size(), ring.count() + 1);
    EXPECT_EQ(topology(graph), (GraphTopology{1, 1}));
    expect_well_formed(graph);
}

TEST(ExtractGraph, KeepsTheHoleInARingOfJunctionVoxels) {
    // Four voxels around one empty place, each with an arm of its own: all are junction voxels.
    voxel::BitVolume diamond(Vec3i(21, 21, 3));
    draw(diamond, {9, 10, 1}, {1, 10, 1});
    draw(diamond, {11, 10, 1}, {19, 10, 1});
    draw(diamond, {10, 9, 1}, {10, 1, 1});
    draw(diamond, {10, 11, 1}, {10, 19, 1});
    const voxel::BettiNumbers betti = voxel::betti_numbers(diamond);
    ASSERT_EQ(betti.tunnels, 1);
    const SkeletonGraph graph = graph_of(diamond);
    EXPECT_EQ(topology(graph), (GraphTopology{1, 1}));
    expect_well_formed(graph);
}

TEST(ExtractGraph, HasTheTunnelsOfTheBuiltShapesAsCycles) {
    for (const test::VolumeShape& shape : test::volume_shapes()) {
        if (shape.betti.cavities > 0) continue;
        for (const ThinningMethod method : {ThinningMethod::kAnchored, ThinningMethod::kParallel}) {
            SCOPED_TRACE(shape.name + " " + std::string(to_string(method)));
            ThinningOptions options;
            options.method = method;
            const voxel::DistanceField distance = voxel::distance_transform(shape.volume);
            const SkeletonGraph graph =
                extract_graph(thin(shape.volume, distance, options), distance);
            EXPECT_EQ(topology(graph),
                      (GraphTopology{shape.betti.components, shape.betti.tunnels}));
            expect_well_formed(graph);
        }
    }
}

TEST(ExtractGraph, HasTheTunnelsOfRandomCurveSkeletonsAsCycles) {
    int tunnels = 0;
    int checked = 0;
    for (unsigned round = 0; round < 400; ++round) {
        const double density = 0.02 + 0.02 * (round % 8);
        const voxel::BitVolume solid = test::random_volume(Vec3i(12, 13, 14), density, round);
        const voxel::DistanceField distance = voxel::distance_transform(solid);
        const voxel::BitVolume skeleton = thin(solid, distance);
        const voxel::BettiNumbers betti = voxel::betti_numbers(skeleton);
        if (betti.cavities > 0) continue;
        const SkeletonGraph graph = extract_graph(skeleton, distance);
        ASSERT_EQ(topology(graph), (GraphTopology{betti.components, betti.tunnels})) << round;
        expect_well_formed(graph);
        tunnels += betti.tunnels;
        ++checked;
    }
    EXPECT_GT(checked, 200);
    EXPECT_GT(tunnels, 1000);
}

TEST(SkeletonGraph, ScalesWithTheWorld) {
    voxel::BitVolume line(Vec3i(20, 5, 5));
    draw(line, {3, 2, 2}, {12, 2, 2});
    const SkeletonGraph grid = graph_of(line);
    WorldFromGrid world_from_grid;
    world_from_grid.origin = Vec3(1.0, -2.0, 3.0);
    world_from_grid.voxel_size = 0.25;
    world_from_grid.rotation = test::random_rotation(5);
    const SkeletonGraph world = to_world(grid, world_from_grid);
    EXPECT_NEAR(world.branches[0].length(), 0.25 * grid.branches[0].length(), 1e-12);
    EXPECT_DOUBLE_EQ(world.nodes[0].radius, 0.25 * grid.nodes[0].radius);
    EXPECT_LT((world_from_grid.grid(world.nodes[1].position) - grid.nodes[1].position).norm(),
              1e-9);
    EXPECT_EQ(topology(world), topology(grid));
}

}  // namespace
}  // namespace ossuary::skeleton
