#include "engine/decomposition/decompose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/decomposition/refine_borders.h"
#include "engine/decomposition/seg_file.h"
#include "engine/decomposition/segmentation_metrics.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/read_mesh.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::decomposition {
namespace {

Segmentation parts_of(const mesh::TriangleMesh& mesh, std::size_t parts = 0) {
    const auto result = decompose(mesh, {.parts = parts});
    EXPECT_TRUE(result.ok()) << result.error().message;
    return result.ok() ? result->segmentation : Segmentation{};
}

/// Two balls of one size joined by a thin rod, as one closed surface of revolution about x.
mesh::TriangleMesh dumbbell() {
    constexpr int kRings = 120, kSides = 48;
    mesh::TriangleMesh mesh;
    const auto radius = [](double x) {
        const double ball = 1.0 - (std::abs(x) - 2.5) * (std::abs(x) - 2.5);
        const double rod = std::abs(x) < 2.5 ? 0.15 : 0.0;
        return std::max(std::sqrt(std::max(0.0, ball)), rod);
    };
    for (int ring = 1; ring < kRings; ++ring) {
        const double x = -3.5 + 7.0 * ring / kRings;
        for (int side = 0; side < kSides; ++side) {
            const double angle = 2.0 * M_PI * side / kSides;
            mesh.vertices.emplace_back(x, radius(x) * std::cos(angle), radius(x) * std::sin(angle));
        }
    }
    const auto at = [](int ring, int side) {
        return static_cast<std::uint32_t>(ring * kSides + side % kSides);
    };
    for (int ring = 0; ring + 2 < kRings; ++ring) {
        for (int side = 0; side < kSides; ++side) {
            mesh.triangles.push_back({at(ring, side), at(ring + 1, side), at(ring + 1, side + 1)});
            mesh.triangles.push_back({at(ring, side), at(ring + 1, side + 1), at(ring, side + 1)});
        }
    }
    const auto left = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(-3.5, 0.0, 0.0);
    mesh.vertices.emplace_back(3.5, 0.0, 0.0);
    for (int side = 0; side < kSides; ++side) {
        mesh.triangles.push_back({left, at(0, side), at(0, side + 1)});
        mesh.triangles.push_back({left + 1, at(kRings - 2, side + 1), at(kRings - 2, side)});
    }
    return mesh;
}

/// How many connected pieces the parts have in all.
std::size_t connected_pieces(const mesh::TriangleMesh& mesh, const Segmentation& segmentation) {
    const auto across = mesh::adjacent_triangles(mesh, mesh::build_edge_table(mesh));
    std::vector<bool> seen(mesh.triangles.size(), false);
    std::size_t pieces = 0;
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
        if (seen[start]) continue;
        ++pieces;
        std::vector<std::uint32_t> open = {start};
        seen[start] = true;
        while (!open.empty()) {
            const std::uint32_t t = open.back();
            open.pop_back();
            for (const std::uint32_t other : across[t]) {
                if (other == mesh::kNoTriangle || seen[other]) continue;
                if (segmentation.labels[other] != segmentation.labels[t]) continue;
                seen[other] = true;
                open.push_back(other);
            }
        }
    }
    return pieces;
}

TEST(Decompose, NamesEachPartOfTheThesisMethodByTheBranchThatMadeIt) {
    const auto result =
        decompose(test::capsule_tree_mesh(), {.method = DecompositionMethod::kThesis});
    ASSERT_TRUE(result.ok()) << result.error().message;
    std::set<std::int32_t> branches;
    for (const auto& part : result->parts) {
        EXPECT_GE(part.branch, 0);
        EXPECT_LT(part.branch, static_cast<std::int32_t>(result->skeleton.branches.size()));
        branches.insert(part.branch);
    }
    EXPECT_GT(result->parts.size(), 1U);
    EXPECT_EQ(branches.size(), result->parts.size());
    for (const StageTime& time : result->stage_times) EXPECT_NE(time.stage, "pairs");
}

TEST(Decompose, PartsTheBallsOfADumbbell) {
    const mesh::TriangleMesh mesh = dumbbell();
    const Segmentation segmentation = parts_of(mesh);
    EXPECT_GE(segmentation.parts, 2u);
    std::set<std::uint32_t> left, right;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.corners(t);
        const double x = (a + b + c).x() / 3.0;
        if (x < -2.0) left.insert(segmentation.labels[t]);
        if (x > 2.0) right.insert(segmentation.labels[t]);
    }
    EXPECT_EQ(left.size(), 1u);
    EXPECT_EQ(right.size(), 1u);
    EXPECT_NE(left, right);
}

TEST(Decompose, LeavesABallWhole) {
    EXPECT_EQ(parts_of(test::icosphere_mesh(Vec3::Zero(), 1.0, 4)).parts, 1u);
}

TEST(Decompose, MakesAsManyConnectedPartsAsAreAskedFor) {
    const mesh::TriangleMesh mesh = dumbbell();
    for (const std::size_t parts : {1u, 2u, 3u, 7u}) {
        const Segmentation segmentation = parts_of(mesh, parts);
        EXPECT_EQ(segmentation.parts, parts);
        EXPECT_EQ(connected_pieces(mesh, segmentation), parts);
    }
}

TEST(Decompose, SaysWhatItsPartsAreLike) {
    const mesh::TriangleMesh mesh = dumbbell();
    const auto result = decompose(mesh, {.parts = 3});
    ASSERT_TRUE(result.ok());
    std::size_t triangles = 0;
    for (std::size_t p = 0; p < result->parts.size(); ++p) {
        const Decomposition::Part& part = result->parts[p];
        triangles += part.triangles;
        EXPECT_GT(part.area, 0.0);
        if (p > 0) {
            EXPECT_LE(part.area, result->parts[p - 1].area);
        }
        EXPECT_LT(part.branch, static_cast<std::int32_t>(result->skeleton.branches.size()));
        for (const std::uint32_t neighbor : part.neighbors) {
            EXPECT_THAT(result->parts[neighbor].neighbors,
                        ::testing::Contains(static_cast<std::uint32_t>(p)));
        }
    }
    EXPECT_EQ(triangles, mesh.triangles.size());
    // The rod lies between the balls.
    EXPECT_THAT(result->parts[2].neighbors, ::testing::ElementsAre(0u, 1u));
}

TEST(Decompose, GivesTheSameEveryTime) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    EXPECT_EQ(parts_of(mesh), parts_of(mesh));
}

TEST(Decompose, DoesNotDependOnPlaceAndSize) {
    const mesh::TriangleMesh mesh = dumbbell();
    const Mat3 larger = 4.0 * Mat3::Identity();
    const Segmentation moved = parts_of(test::transformed(mesh, larger, Vec3(64.0, -32.0, 8.0)));
    const std::vector<double> areas(mesh.triangles.size(), 1.0);
    EXPECT_LT(segmentation_errors(parts_of(mesh), moved, areas).rand_index_error, 0.02);
}

TEST(Decompose, LabelsEveryTriangleOfBadSurfaces) {
    mesh::TriangleMesh soup =
        test::merged(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::box_mesh({3, 0, 0}, {4, 1, 1}));
    mesh::TriangleMesh fan = test::box_mesh({0, 0, 0}, {1, 1, 1});  // an edge of three triangles
    fan.vertices.emplace_back(2.0, 2.0, 2.0);
    fan.triangles.push_back({fan.triangles[0][0], fan.triangles[0][1],
                             static_cast<std::uint32_t>(fan.vertices.size() - 1)});
    mesh::TriangleMesh folded = test::box_mesh({0, 0, 0}, {1, 1, 1});  // triangles without area
    folded.triangles.push_back({0, 1, 1});
    folded.triangles.push_back({2, 2, 2});
    mesh::TriangleMesh single;
    single.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    single.triangles = {{0, 1, 2}};
    mesh::TriangleMesh line = single;  // extent without area
    line.vertices[2] = {2, 0, 0};
    mesh::TriangleMesh open = test::open_box_mesh({0, 0, 0}, {1, 1, 1});
    mesh::TriangleMesh torn = test::without_some_triangles(test::torus_mesh(3.0, 1.0), 0.3, 5);
    for (mesh::TriangleMesh* mesh : {&soup, &fan, &folded, &single, &line, &open, &torn}) {
        const Segmentation segmentation = parts_of(*mesh);
        EXPECT_EQ(segmentation.labels.size(), mesh->triangles.size());
        for (const std::uint32_t label : segmentation.labels) EXPECT_LT(label, segmentation.parts);
    }
    EXPECT_EQ(parts_of(single).parts, 1u);
    EXPECT_EQ(parts_of(soup, 2).parts, 2u);
}

TEST(Decompose, SaysWhyItCannot) {
    const auto empty = decompose(mesh::TriangleMesh{});
    ASSERT_FALSE(empty.ok());
    EXPECT_EQ(empty.error().code, ErrorCode::kMeshEmpty);
    mesh::TriangleMesh point;
    point.vertices = {{1, 1, 1}};
    point.triangles = {{0, 0, 0}};
    const auto no_extent = decompose(point);
    ASSERT_FALSE(no_extent.ok());
    EXPECT_EQ(no_extent.error().code, ErrorCode::kMeshNoExtent);
    mesh::TriangleMesh single;
    single.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    single.triangles = {{0, 1, 2}};
    for (const std::size_t parts : {std::size_t{2}, kMaxParts + 1}) {
        const auto too_many = decompose(single, {.parts = parts});
        ASSERT_FALSE(too_many.ok());
        EXPECT_EQ(too_many.error().code, ErrorCode::kInvalidArgument);
    }
}

TEST(Decompose, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const auto result = decompose(dumbbell(), {}, stop.get_token());
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::kCancelled);
}

TEST(FaceSegmentation, GivesAFaceThePartOfMostOfItsArea) {
    const auto read = mesh::read_mesh(
        "OFF\n5 3 0\n0 0 0\n4 0 0\n4 1 0\n0 1 0\n5 1 0\n4 0 1 2 3\n2 0 1\n3 1 4 2\n", "x.off");
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_EQ(read->mesh.triangles.size(), 3u);
    const Segmentation faces = face_segmentation(read->mesh, {{1, 1, 2}, 3});
    EXPECT_THAT(faces.labels, ::testing::ElementsAre(1u, 0u, 2u));
}

TEST(RefineBorders, MovesABorderIntoTheNeckNearIt) {
    // Cut off the middle of the rod, where it is no cheaper than anywhere else on the rod, but the
    // crease at its end is within reach.
    const mesh::TriangleMesh mesh = dumbbell();
    const SurfaceGraph surface = surface_graph(mesh);
    std::vector<std::uint32_t> labels;
    for (const Vec3& center : surface.centers) labels.push_back(center.x() < -1.3 ? 0 : 1);
    refine_borders(surface, labels, {.reach = 0.1, .crease_weight = 4.0});
    double border = -10.0;
    for (std::size_t t = 0; t < labels.size(); ++t) {
        if (labels[t] == 0) border = std::max(border, surface.centers[t].x());
    }
    EXPECT_NEAR(border, -1.51, 0.08);  // where ball and rod meet: 2.5 - sqrt(1 - .15^2)
}

TEST(Decompose, CutsModelsOfTheBenchmarkAsPeopleDo) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const auto folder = data / "princeton-segmentation";
    double sum = 0.0;
    int models = 0;
    for (int model = 7; model <= 400; model += 20) {  // one of each class
        const std::string name = std::to_string(model);
        const auto mesh = mesh::read_mesh(folder / "off" / (name + ".off"));
        if (!mesh.ok()) continue;
        const std::size_t faces = mesh->mesh.triangles.size();
        const auto humans = read_segmentations(folder / "seg", name, faces);
        ASSERT_TRUE(humans.ok()) << humans.error().message;
        const Segmentation segmentation = parts_of(mesh->mesh);
        const std::vector<double> areas(faces, 1.0);
        double error = 0.0;
        for (const Segmentation& human : *humans) {
            error += segmentation_errors(human, segmentation, areas).rand_index_error;
        }
        sum += error / static_cast<double>(humans->size());
        ++models;
    }
    EXPECT_EQ(models, 19);
    EXPECT_LT(sum / models, 0.140);
}

}  // namespace
}  // namespace ossuary::decomposition
