#include "engine/mesh/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::mesh {
namespace {

const TriangleMesh kTree = test::capsule_tree_mesh();

TriangleMesh speck_at(const Vec3& place, double size = 1e-3) {
    return test::icosphere_mesh(place, size / 2, 1);
}

double size_of(const TriangleMesh& mesh) {
    Box3 box;
    for (const Vec3& v : mesh.vertices) box.extend(v);
    return box.sizes().maxCoeff();
}

/// Each triangle with vertices of its own.
TriangleMesh soup_of(const TriangleMesh& mesh) {
    TriangleMesh soup = mesh;
    soup.vertices.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const Vec3& corner : mesh.corners(t)) soup.vertices.push_back(corner);
        soup.triangles[t] = {first, first + 1, first + 2};
    }
    return soup;
}

void expect_whole(const TriangleMesh& mesh, const char* what) {
    const Body body = find_body(mesh);
    EXPECT_FALSE(body.mesh.has_value()) << what;
    EXPECT_EQ(body.pieces_apart, 0u) << what;
}

/// The first triangles are the body, all others are not.
void expect_first(std::size_t triangles, const TriangleMesh& mesh, const std::string& what) {
    const Body body = find_body(mesh);
    ASSERT_TRUE(body.mesh.has_value()) << what;
    const std::vector<TriangleMesh::Triangle> first(
        mesh.triangles.begin(), mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangles));
    EXPECT_EQ(body.mesh->triangles, first) << what;
    EXPECT_EQ(body.mesh->vertices, mesh.vertices) << what;
    EXPECT_EQ(body.triangles_apart, mesh.triangles.size() - triangles) << what;
}

TEST(Body, IsTheWholeOfWhatHoldsTogether) {
    for (const test::MeshShape& shape : test::mesh_shapes()) {
        expect_whole(shape.mesh, shape.name.c_str());
        expect_whole(soup_of(shape.mesh), shape.name.c_str());
        expect_whole(test::without_some_triangles(shape.mesh, 0.3, 1), shape.name.c_str());
    }
    expect_whole({}, "nothing");
}

TEST(Body, LeavesOutASpeckAtAnyDistance) {
    for (const TriangleMesh& model :
         {kTree, soup_of(kTree), test::without_some_triangles(kTree, 0.2, 3)}) {
        const double size = size_of(model);
        for (const double distance : {2.0, 20.0, 2000.0, 1e6, 1e12}) {
            const TriangleMesh mesh = test::merged(
                model, speck_at(Vec3(0.6, 0.7, -0.4).normalized() * distance * size, 1e-3 * size));
            expect_first(model.triangles.size(), mesh, std::to_string(distance));
            EXPECT_EQ(find_body(mesh).pieces_apart, 1u);
            EXPECT_TRUE(find_body(mesh).axes.isApprox(find_body(model).axes, 1e-12));
        }
    }
}

TEST(Body, LeavesOutSpecksThatAreFarFromEachOther) {
    const double size = size_of(kTree);
    // Two that are farther from each other than the model is large, beside one a thousand times
    // nearer, and one more at each factor of ten.
    TriangleMesh mesh = test::merged(kTree, speck_at(size * Vec3(1e6, 0, 0)));
    mesh = test::merged(mesh, speck_at(size * Vec3(1e6, 2, 0)));
    mesh = test::merged(mesh, speck_at(size * Vec3(0, 1e3, 0)));
    for (double distance = 3; distance < 1e9; distance *= 10) {
        mesh = test::merged(mesh, speck_at(size * Vec3(0, 0, -distance)));
    }
    expect_first(kTree.triangles.size(), mesh, "specks");
}

TEST(Body, KeepsSeveralPiecesOfLikeSize) {
    const double size = size_of(kTree);
    for (const double distance : {3.0, 1e3, 1e6}) {
        const TriangleMesh two = test::merged(
            kTree, test::transformed(kTree, 0.3 * Mat3::Identity(), size * Vec3(distance, 0, 0)));
        expect_whole(two, "two");
        // A speck near one of them and one as far away again.
        TriangleMesh mesh = test::merged(two, speck_at(size * Vec3(0, 2, 0)));
        mesh = test::merged(mesh, speck_at(size * Vec3(0, 2 * distance, distance)));
        const Body body = find_body(mesh);
        ASSERT_TRUE(body.mesh.has_value());
        EXPECT_GE(body.mesh->triangles.size(), two.triangles.size());
        EXPECT_LE(size_of(*find_body(mesh).mesh), 4 * distance * size);
    }
}

TEST(Body, KeepsManySmallPiecesThatAreTheModel) {
    std::mt19937_64 random(1);
    const auto at_random = [&](double low, double high) {
        return low + (high - low) * test::next_unit(random);
    };
    TriangleMesh rice, swarm, chain, crown = test::capsule_mesh({0, 0, 0}, {0, 0, 2}, 0.1);
    for (int i = 0; i < 400; ++i) {
        const double angle = at_random(0, 2 * std::numbers::pi);
        const double radius = std::sqrt(at_random(0, 1));
        const Vec3 place(radius * std::cos(angle), radius * std::sin(angle), at_random(0, 0.05));
        rice = test::merged(rice, test::capsule_mesh(place, place + Vec3(0.05, 0, 0), 0.01, 6));
        // Twenty times as far from each other as they are large.
        const Vec3 anywhere(at_random(-3, 3), at_random(-3, 3), at_random(-3, 3));
        swarm = test::merged(swarm, test::icosphere_mesh(anywhere, 0.02, 1));
        const Vec3 twig =
            Vec3(0, 0, 2) + Vec3(at_random(-1, 1), at_random(-1, 1), at_random(-1, 1));
        crown = test::merged(crown, test::box_mesh(twig, twig + Vec3(0.08, 0.06, 0.001)));
    }
    for (int i = 0; i < 40; ++i) {
        const Mat3 turn = Eigen::AngleAxisd(i % 2 == 0 ? 0.0 : 1.57, Vec3::UnitX()).matrix();
        chain = test::merged(
            chain, test::transformed(test::torus_mesh(1, 0.2, 24, 8), turn, {1.4 * i, 0, 0}));
    }
    // A grain that lies apart from all others may go.
    EXPECT_GE(find_body(rice).of(rice).triangles.size(), rice.triangles.size() * 99 / 100);
    expect_whole(swarm, "swarm");
    expect_whole(chain, "chain");
    expect_whole(crown, "crown");
}

TEST(Body, KeepsALongWireHoweverThin) {
    const double size = size_of(kTree);
    const TriangleMesh wire =
        test::capsule_mesh(size * Vec3(5, 0, 0), size * Vec3(5, 1, 0), 1e-5 * size, 6);
    expect_whole(test::merged(kTree, wire), "wire");
}

TEST(Body, KeepsASpeckThatLiesNear) {
    const double size = size_of(kTree);
    const Vec3 tip = kTree.vertices.back();
    expect_whole(test::merged(kTree, speck_at(tip + Vec3(0.02 * size, 0, 0))), "near");
}

TEST(Body, DoesNotDependOnPoseSizePlaceOrNumbering) {
    const double size = size_of(kTree);
    TriangleMesh mesh = test::merged(kTree, speck_at(size * Vec3(2, 0, 0)));
    mesh = test::merged(mesh, speck_at(size * Vec3(0, -70, 900)));
    mesh = test::merged(mesh, test::transformed(kTree, 0.4 * Mat3::Identity(), {0, 3 * size, 0}));
    const std::size_t kept = find_body(mesh).of(mesh).triangles.size();
    EXPECT_EQ(kept, 2 * kTree.triangles.size());
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const double scale = std::pow(10.0, static_cast<double>(seed) - 5);
        TriangleMesh moved =
            test::transformed(mesh, scale * test::random_rotation(seed), scale * Vec3(7, -3, 2));
        if (seed % 2 == 0) moved = test::renumbered(moved, seed);
        if (seed % 3 == 0) moved = test::transformed(moved, Vec3(-1, 1, 1).asDiagonal());
        EXPECT_EQ(find_body(moved).of(moved).triangles.size(), kept) << seed;
    }
}

TEST(Body, IsFoundAlongGivenAxes) {
    const TriangleMesh mesh = test::merged(kTree, speck_at(50 * size_of(kTree) * Vec3::UnitX()));
    const Mat3 axes = test::random_rotation(3);
    const Body body = find_body(mesh, {.axes = axes});
    EXPECT_EQ(body.axes, axes);
    EXPECT_EQ(body.of(mesh).triangles, kTree.triangles);
}

TEST(Body, IsTheWholeWhereNoExtentIsAskedOrWhenStopped) {
    const TriangleMesh mesh = test::merged(kTree, speck_at(50 * size_of(kTree) * Vec3::UnitX()));
    BodyOptions options;
    options.min_extent = 0;
    EXPECT_FALSE(find_body(mesh, options).mesh.has_value());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(find_body(mesh, {}, stop.get_token()).mesh.has_value());
}

}  // namespace
}  // namespace ossuary::mesh
