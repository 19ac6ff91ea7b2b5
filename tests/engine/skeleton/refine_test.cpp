#include "engine/skeleton/refine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/skeleton/extract_graph.h"
#include "engine/skeleton/graph_surgery.h"
#include "engine/skeleton/node_significance.h"
#include "engine/skeleton/prune_protrusion.h"
#include "engine/skeleton/prune_significance.h"
#include "engine/skeleton/thinning.h"
#include "engine/voxel/border.h"
#include "tests/engine/skeleton/count_of_degree.h"
#include "tests/support/shapes.h"

namespace ossuary::skeleton {
namespace {

struct Prepared {
    SkeletonGraph graph;
    std::vector<Vec3> surface;
};

Prepared prepare(const voxel::BitVolume& solid, ThinningMethod method = ThinningMethod::kAnchored) {
    ThinningOptions options;
    options.method = method;
    const voxel::DistanceField distance = voxel::distance_transform(solid);
    Prepared prepared{extract_graph(thin(solid, distance, options), distance), {}};
    for (const Vec3i& v : voxel::border_points(solid)) {
        prepared.surface.push_back(v.cast<double>() + Vec3::Constant(0.5));
    }
    return prepared;
}

using test::count_of_degree;

/// A star of straight arms in the plane around the origin.
SkeletonGraph star(const std::vector<double>& lengths, double centre_radius, double tip_radius) {
    SkeletonGraph graph;
    graph.nodes.push_back({Vec3::Zero(), centre_radius, 0.0, 0});
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(lengths.size());
        const Vec3 tip = lengths[i] * Vec3(std::cos(angle), std::sin(angle), 0.0);
        graph.nodes.push_back({tip, tip_radius, 0.0, 0});
        SkeletonGraph::Branch branch;
        branch.b = static_cast<std::uint32_t>(i + 1);
        const int steps = std::max(1, static_cast<int>(lengths[i]));
        for (int s = 0; s <= steps; ++s) {
            const double share = static_cast<double>(s) / steps;
            branch.points.push_back(share * tip);
            branch.radii.push_back(centre_radius + share * (tip_radius - centre_radius));
        }
        graph.branches.push_back(branch);
    }
    update_degrees(graph);
    return graph;
}

TEST(NodeSignificance, IsTheLengthsOfTheBranchesPlusTheTenNearestSurfacePoints) {
    SkeletonGraph graph = star({10.0, 20.0, 30.0}, 4.0, 1.0);
    // Twelve points at distances 1..12 from the centre, far from everything else.
    std::vector<Vec3> surface;
    for (int i = 1; i <= 12; ++i) surface.push_back(Vec3(0.0, 0.0, i));
    const std::vector<double> sums = surface_distance_sums(graph, surface);
    EXPECT_DOUBLE_EQ(sums[0], 55.0);
    set_significance(graph, sums);
    EXPECT_NEAR(graph.nodes[0].significance, 60.0 + 55.0, 1e-9);
    EXPECT_NEAR(graph.nodes[1].significance, 10.0 + sums[1], 1e-9);
}

TEST(NodeSignificance, IsZeroForDegreeTwoAndTakesFewPointsAsTheyAre) {
    SkeletonGraph graph = star({10.0, 20.0}, 4.0, 1.0);
    const std::vector<Vec3> surface = {Vec3(0.0, 0.0, 3.0), Vec3(0.0, 0.0, 4.0)};
    const std::vector<double> sums = surface_distance_sums(graph, surface);
    EXPECT_DOUBLE_EQ(sums[0], 7.0);
    set_significance(graph, sums);
    EXPECT_EQ(graph.nodes[0].significance, 0.0);
    EXPECT_EQ(surface_distance_sums(graph, {}), std::vector<double>(3, 0.0));
}

TEST(GraphSurgery, JoinsTheTwoBranchesThatARemovedLeafLeaves) {
    SkeletonGraph graph = star({10.0, 20.0, 30.0}, 4.0, 1.0);
    const std::vector<Leaf> all = leaves(graph);
    ASSERT_EQ(all.size(), 3u);
    remove_leaf(graph, all[0]);
    ASSERT_EQ(graph.branches.size(), 1u);
    EXPECT_EQ(graph.nodes.size(), 2u);
    EXPECT_NEAR(graph.branches[0].length(), 50.0, 1e-9);
    EXPECT_EQ(graph.branches[0].points.front(), graph.nodes[graph.branches[0].a].position);
    EXPECT_EQ(graph.branches[0].points.back(), graph.nodes[graph.branches[0].b].position);
    EXPECT_TRUE(leaves(graph).empty()) << "the last branch of a component is no leaf";
}

TEST(GraphSurgery, ContractingABranchKeepsCyclesAndComponents) {
    // Two junctions joined by three branches: contracting one makes two loops at one node.
    SkeletonGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 3.0, 0.0, 3}, {Vec3(4, 0, 0), 1.0, 0.0, 3}};
    for (const double y : {-3.0, 0.0, 3.0}) {
        SkeletonGraph::Branch branch;
        branch.a = 0;
        branch.b = 1;
        branch.points = {graph.nodes[0].position, Vec3(2, y, 0), graph.nodes[1].position};
        branch.radii = {3.0, 1.0, 1.0};
        graph.branches.push_back(branch);
    }
    const GraphTopology before = topology(graph);
    EXPECT_EQ(before, (GraphTopology{1, 2}));
    contract_branch(graph, 1);
    EXPECT_EQ(topology(graph), before);
    ASSERT_EQ(graph.nodes.size(), 1u);
    EXPECT_EQ(graph.nodes[0].position, Vec3(1, 0, 0)) << "nearer to the thicker end";
    EXPECT_EQ(graph.nodes[0].radius, 3.0);
    EXPECT_EQ(graph.nodes[0].degree, 4);
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        EXPECT_EQ(branch.points.front(), graph.nodes[0].position);
        EXPECT_EQ(branch.points.back(), graph.nodes[0].position);
    }
}

TEST(ProtrusionPruning, RemovesWhatHardlyLeavesTheJunctionsBall) {
    SkeletonGraph graph = star({5.0, 40.0, 40.0, 40.0}, 5.0, 1.0);
    prune_by_protrusion(graph);
    EXPECT_EQ(graph.branches.size(), 3u) << "(5 + 1) / 5 is below 1.6";
    SkeletonGraph spared = star({5.0, 40.0, 40.0, 40.0}, 5.0, 1.0);
    prune_by_protrusion(spared, {.min_protrusion = 1.1});
    EXPECT_EQ(spared.branches.size(), 4u);
}

TEST(ProtrusionPruning, MergesJunctionsWithinOneBall) {
    SkeletonGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 4.0, 0, 0},   {Vec3(3, 0, 0), 4.0, 0, 0},
                   {Vec3(-20, 9, 0), 1.0, 0, 0}, {Vec3(-20, -9, 0), 1.0, 0, 0},
                   {Vec3(20, 9, 0), 1.0, 0, 0},  {Vec3(20, -9, 0), 1.0, 0, 0}};
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> ends = {
        {0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}};
    for (const auto& [a, b] : ends) {
        SkeletonGraph::Branch branch;
        branch.a = a;
        branch.b = b;
        branch.points = {graph.nodes[a].position, graph.nodes[b].position};
        branch.radii = {graph.nodes[a].radius, graph.nodes[b].radius};
        graph.branches.push_back(branch);
    }
    SkeletonGraph apart = graph;
    prune_by_protrusion(graph);
    EXPECT_EQ(graph.nodes.size(), 5u);
    EXPECT_EQ(count_of_degree(graph, 4), 1);
    prune_by_protrusion(apart, {.merge_junctions = false});
    EXPECT_EQ(apart.nodes.size(), 6u);
}

TEST(ProtrusionPruning, RaisesItsThresholdUntilFewLeavesAreLeft) {
    std::vector<double> lengths;
    for (int i = 0; i < 40; ++i) lengths.push_back(30.0 + i);
    SkeletonGraph graph = star(lengths, 5.0, 1.0);
    prune_by_protrusion(graph);
    EXPECT_LE(leaves(graph).size(), 24u);
    EXPECT_GT(leaves(graph).size(), 10u) << "no more than needed";
    double shortest = 1e9;
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        shortest = std::min(shortest, branch.length());
    }
    EXPECT_GE(shortest, 30.0 + 40 - 24) << "the least protruding went";
}

TEST(SignificancePruning, RemovesShortBranchesAndPrunesLessWithALargerScale) {
    const SkeletonGraph graph = star({2.0, 40.0, 40.0, 40.0}, 5.0, 1.0);
    SkeletonGraph pruned = graph;
    prune_by_significance(pruned, {}, 1.0);
    EXPECT_EQ(pruned.branches.size(), 3u);
    SkeletonGraph spared = graph;
    prune_by_significance(spared, {}, 100.0);
    EXPECT_EQ(spared.branches.size(), 4u);
}

TEST(Pruning, NeverRemovesACycleOrAComponent) {
    for (const test::VolumeShape& shape : test::volume_shapes()) {
        for (const ThinningMethod method : {ThinningMethod::kAnchored, ThinningMethod::kParallel}) {
            const Prepared prepared = prepare(shape.volume, method);
            const GraphTopology expected = topology(prepared.graph);
            for (const PruningMethod pruning :
                 {PruningMethod::kProtrusion, PruningMethod::kSignificance, PruningMethod::kNone}) {
                SCOPED_TRACE(shape.name + " " + std::string(to_string(pruning)));
                RefineOptions options;
                options.pruning = pruning;
                options.min_protrusion = 50.0;
                options.significance_scale = 0.01;
                options.max_leaves = 0;
                const RefinedSkeleton refined = refine(prepared.graph, prepared.surface, options);
                EXPECT_EQ(topology(refined.pruned), expected);
                EXPECT_EQ(topology(refined.refined), expected);
                EXPECT_FALSE(refined.refined.empty());
                const bool bare = leaves(refined.pruned).empty();
                EXPECT_TRUE(bare || pruning == PruningMethod::kNone);
            }
        }
    }
}

TEST(Refine, LeavesATorusOneClosedCurveNearItsAxis) {
    const test::VolumeShape torus = test::torus(24.0, 7.0);
    for (const ThinningMethod method : {ThinningMethod::kAnchored, ThinningMethod::kParallel}) {
        SCOPED_TRACE(to_string(method));
        const Prepared prepared = prepare(torus.volume, method);
        const SkeletonGraph refined = refine(prepared.graph, prepared.surface).refined;
        ASSERT_EQ(refined.branches.size(), 1u);
        ASSERT_EQ(refined.nodes.size(), 1u);
        EXPECT_EQ(refined.nodes[0].degree, 2);
        const double circle = 2.0 * std::numbers::pi * 24.0;
        EXPECT_NEAR(refined.branches[0].length(), circle, 0.12 * circle);
    }
}

TEST(Refine, FindsTheLimbsOfATree) {
    const Prepared prepared = prepare(test::capsule_tree().volume);
    const SkeletonGraph refined = refine(prepared.graph, prepared.surface).refined;
    EXPECT_EQ(count_of_degree(refined, 1), 6);
}

TEST(Refine, FindsTheSameLimbsInAMirroredOrPermutedVolume) {
    const voxel::BitVolume solid = test::capsule_tree().volume;
    const Prepared first = prepare(solid);
    const SkeletonGraph expected = refine(first.graph, first.surface).refined;
    std::vector<voxel::BitVolume> copies;
    for (int axis = 0; axis < 3; ++axis) copies.push_back(test::mirrored(solid, axis));
    for (const Vec3i& order : {Vec3i(1, 2, 0), Vec3i(2, 0, 1), Vec3i(1, 0, 2)}) {
        copies.push_back(test::permuted(solid, order));
    }
    double length = 0.0;
    for (const auto& branch : expected.branches) length += branch.length();
    for (const voxel::BitVolume& copy : copies) {
        const Prepared prepared = prepare(copy);
        const SkeletonGraph refined = refine(prepared.graph, prepared.surface).refined;
        EXPECT_EQ(refined.nodes.size(), expected.nodes.size());
        EXPECT_EQ(refined.branches.size(), expected.branches.size());
        double copy_length = 0.0;
        for (const auto& branch : refined.branches) copy_length += branch.length();
        EXPECT_NEAR(copy_length, length, 0.05 * length);
    }
}

TEST(Refine, LeavesTheSameSkeletonWithoutSignificance) {
    const Prepared prepared = prepare(test::capsule_tree().volume);
    RefineOptions options;
    options.significance = false;
    const SkeletonGraph with = refine(prepared.graph, prepared.surface).refined;
    const SkeletonGraph without = refine(prepared.graph, {}, options).refined;
    ASSERT_EQ(without.nodes.size(), with.nodes.size());
    for (std::size_t i = 0; i < with.nodes.size(); ++i) {
        EXPECT_EQ(without.nodes[i].position, with.nodes[i].position);
        EXPECT_GT(with.nodes[i].significance, 0.0);
        EXPECT_EQ(without.nodes[i].significance, 0.0);
    }
    ASSERT_EQ(without.branches.size(), with.branches.size());
    for (std::size_t i = 0; i < with.branches.size(); ++i) {
        EXPECT_EQ(without.branches[i].points, with.branches[i].points);
    }
}

TEST(Refine, KeepsBranchesAttachedToTheirNodes) {
    const Prepared prepared = prepare(test::double_torus().volume);
    for (const SmoothingScale scale :
         {SmoothingScale::kBendingSum, SmoothingScale::kQuotient, SmoothingScale::kFixed}) {
        RefineOptions options;
        options.smoothing_scale = scale;
        const SkeletonGraph refined = refine(prepared.graph, prepared.surface, options).refined;
        for (const SkeletonGraph::Branch& branch : refined.branches) {
            EXPECT_EQ(branch.points.front(), refined.nodes[branch.a].position);
            EXPECT_EQ(branch.points.back(), refined.nodes[branch.b].position);
            ASSERT_EQ(branch.points.size(), branch.radii.size());
        }
    }
}

TEST(Refine, TakesAnythingWithoutBranches) {
    const RefinedSkeleton empty = refine({}, {});
    EXPECT_TRUE(empty.refined.empty());
    SkeletonGraph single;
    single.nodes.push_back({Vec3(1, 2, 3), 4.0, 0.0, 0});
    const RefinedSkeleton one = refine(single, {});
    ASSERT_EQ(one.refined.nodes.size(), 1u);
    EXPECT_EQ(one.refined.nodes[0].radius, 4.0);
}

TEST(Refine, NamesItsPruningMethods) {
    for (const PruningMethod method :
         {PruningMethod::kProtrusion, PruningMethod::kSignificance, PruningMethod::kNone}) {
        const auto parsed = parse_pruning_method(to_string(method));
        ASSERT_TRUE(parsed.ok());
        EXPECT_EQ(*parsed, method);
    }
    EXPECT_FALSE(parse_pruning_method("").ok());
}

}  // namespace
}  // namespace ossuary::skeleton
