#include "engine/registration/align.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/mesh/decimate.h"
#include "engine/mesh/read_mesh.h"
#include "tests/engine/registration/odd_body.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::registration {
namespace {

Similarity motion_of(std::uint64_t seed, double scale, bool mirror) {
    Similarity motion{scale, test::random_rotation(seed), Vec3(3, -7, 11)};
    if (mirror) motion.rotation.col(1) *= -1.0;
    return motion;
}

mesh::TriangleMesh moved(const mesh::TriangleMesh& mesh, const Similarity& motion) {
    auto result = test::transformed(mesh, motion.scale * motion.rotation, motion.translation);
    return motion.mirrors() ? test::flipped(result) : result;
}

void expect_on_each_other(const SurfaceAgreement& agreement, double percent) {
    EXPECT_LT(agreement.mean, percent);
    EXPECT_LT(agreement.most, 3.0 * percent);
    EXPECT_GT(agreement.source_explained, 0.98);
    EXPECT_GT(agreement.target_explained, 0.98);
}

TEST(Align, FindsAnyMotion) {
    const mesh::TriangleMesh body = odd_body();
    const Shape shape(body);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Similarity motion = motion_of(seed, 1.0, false);
        const mesh::TriangleMesh other = test::renumbered(moved(body, motion), seed);
        const Alignment found = align(shape, Shape(other));
        expect_on_each_other(found.agreement, 0.1);
        EXPECT_LT((found.placement.point({2, 5, 1}) - motion.point({2, 5, 1})).norm(), 0.05);
        EXPECT_FALSE(found.placement.mirrors());
    }
}

TEST(Align, FindsTheScaleWhenItMay) {
    const mesh::TriangleMesh body = odd_body();
    const Shape shape(body);
    for (const double scale : {0.001, 25.4}) {
        const mesh::TriangleMesh other = moved(body, motion_of(7, scale, false));
        const Alignment found = align(shape, Shape(other), {.scale = true});
        expect_on_each_other(found.agreement, 0.1);
        EXPECT_NEAR(found.placement.scale / scale, 1.0, 2e-3);
        EXPECT_GT(align(shape, Shape(other)).agreement.mean, 2.0);
    }
}

TEST(Align, MirroredCopiesAlignOnlyMirrored) {
    const mesh::TriangleMesh body = odd_body();
    const Shape shape(body);
    const mesh::TriangleMesh other = moved(body, motion_of(5, 1.0, true));
    const Alignment mirrored = align(shape, Shape(other), {.mirror = true});
    expect_on_each_other(mirrored.agreement, 0.1);
    EXPECT_TRUE(mirrored.placement.mirrors());
    EXPECT_LT(align(shape, Shape(other)).agreement.source_explained, 0.95);
}

TEST(Align, OtherTrianglesOfTheSameSurfaceAgree) {
    const mesh::TriangleMesh body = odd_body();
    const Shape shape(body);
    const mesh::TriangleMesh coarse = mesh::decimate(moved(body, motion_of(9, 1.0, false)),
                                                     {.max_triangles = body.triangles.size() / 3});
    expect_on_each_other(align(shape, Shape(coarse)).agreement, 0.3);
}

TEST(Align, NoiseIsSeenAsWhatItIs) {
    const mesh::TriangleMesh body = odd_body();
    mesh::TriangleMesh noisy = moved(body, motion_of(11, 1.0, false));
    std::mt19937_64 random(1);
    const Shape shape(body);
    const double size = 0.003 * shape.surface().diagonal;
    for (Vec3& vertex : noisy.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            vertex[axis] += size * (2.0 * test::next_unit(random) - 1.0);
        }
    }
    const SurfaceAgreement found = align(shape, Shape(noisy)).agreement;
    EXPECT_GT(found.mean, 0.03);
    EXPECT_LT(found.mean, 0.3);
    EXPECT_LT(found.greatest, 1.0);
}

TEST(Align, SymmetricBodiesAlignInSomeWay) {
    const mesh::TriangleMesh bodies[] = {
        test::box_mesh({0, 0, 0}, {1, 1, 1}), test::box_mesh({0, 0, 0}, {1, 1, 4}),
        test::torus_mesh(3.0, 1.0), test::icosphere_mesh({0, 0, 0}, 1.0, 3)};
    for (const mesh::TriangleMesh& body : bodies) {
        const Shape shape(body);
        const mesh::TriangleMesh other = moved(body, motion_of(4, 1.0, false));
        expect_on_each_other(align(shape, Shape(other)).agreement, 0.15);
    }
}

TEST(Align, DifferentBodiesStayApart) {
    const mesh::TriangleMesh tree = test::capsule_tree_mesh();
    const mesh::TriangleMesh body = odd_body();
    const SurfaceAgreement found =
        align(Shape(tree), Shape(body), {.mirror = false, .scale = true}).agreement;
    EXPECT_GT(found.mean, 1.0);
    EXPECT_LT(std::min(found.source_explained, found.target_explained), 0.8);
}

TEST(Align, IsTheSameEveryTime) {
    const mesh::TriangleMesh body = odd_body();
    const mesh::TriangleMesh other = moved(body, motion_of(2, 2.0, false));
    const Alignment once = align(Shape(body), Shape(other), {.scale = true});
    const Alignment again = align(Shape(body), Shape(other), {.scale = true});
    EXPECT_EQ(once.placement.matrix(), again.placement.matrix());
    EXPECT_EQ(once.agreement.greatest, again.agreement.greatest);
}

TEST(Align, RealModelsAlignWithMovedCopies) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const char* name : {"1", "21", "121", "285", "381"}) {
        const auto read =
            mesh::read_mesh(data / "princeton-segmentation" / "off" / (std::string(name) + ".off"));
        if (!read) GTEST_SKIP() << read.error().message;
        const Shape shape(read->mesh);
        const mesh::TriangleMesh other = moved(read->mesh, motion_of(3, 25.4, false));
        const Alignment found = align(shape, Shape(other), {.scale = true});
        EXPECT_LT(found.agreement.mean, 0.1) << name;
        EXPECT_GT(found.agreement.source_explained, 0.99) << name;
    }
}

}  // namespace
}  // namespace ossuary::registration
