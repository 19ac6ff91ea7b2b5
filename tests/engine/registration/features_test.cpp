#include <gtest/gtest.h>

#include <cmath>

#include "engine/registration/closest_points.h"
#include "engine/registration/feature_candidates.h"
#include "engine/registration/local_features.h"
#include "tests/engine/registration/odd_body.h"
#include "tests/support/shapes.h"

namespace ossuary::registration {
namespace {

LocalFeatures features_of(const SurfacePoints& surface, std::vector<double> radii,
                          std::size_t count = 40) {
    return local_features(surface, NearestPoint(surface.points), count, std::move(radii));
}

TEST(SurfacePoints, AreSpreadByAreaAndFaceOutwards) {
    const mesh::TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    const SurfacePoints surface = surface_points(box, {.count = 2200});
    EXPECT_NEAR(surface.area, 22.0, 1e-12);
    EXPECT_NEAR(surface.diagonal, std::sqrt(14.0), 1e-12);
    std::size_t on_largest = 0;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const Vec3 way = surface.points[i] - Vec3(0.5, 1, 1.5);
        EXPECT_GT(surface.normals[i].dot(way), 0.0);
        if (std::abs(surface.normals[i].x()) > 0.5) ++on_largest;
    }
    EXPECT_NEAR(static_cast<double>(on_largest) / 2200.0, 12.0 / 22.0, 0.01);
}

TEST(SurfacePoints, FacesThatLieTheOtherWayMakeNoDifference) {
    const mesh::TriangleMesh body = test::icosphere_mesh({1, 1, 1}, 2.0, 2);
    const SurfacePoints turned = surface_points(test::flipped(body));
    for (std::size_t i = 0; i < turned.points.size(); ++i) {
        EXPECT_GT(turned.normals[i].dot(turned.points[i] - Vec3(1, 1, 1)), 0.0);
    }
}

TEST(NearestPoint, FindsWhatLookingAtAllFinds) {
    const SurfacePoints surface = surface_points(odd_body(), {.count = 500});
    const NearestPoint nearest(surface.points);
    for (const Vec3& point : surface_points(odd_body(), {.count = 50, .seed = 9}).points) {
        double least = 1e300;
        std::size_t near = 0;
        for (const Vec3& other : surface.points) {
            least = std::min(least, (other - point).squaredNorm());
            near += (other - point).norm() < 1.5 ? 1 : 0;
        }
        EXPECT_DOUBLE_EQ(nearest.of(point).squared_distance, least);
        std::vector<NearestPoint::Found> found;
        nearest.within(point, 1.5, found);
        EXPECT_EQ(found.size(), near);
    }
}

TEST(LocalFeatures, AreBlindToMotionScaleAndMirror) {
    const SurfacePoints surface = surface_points(odd_body());
    SurfacePoints moved = surface;
    Similarity motion{7.0, test::random_rotation(3), Vec3(1, 2, 3)};
    motion.rotation.col(2) *= -1.0;
    for (Vec3& point : moved.points) point = motion.point(point);
    for (Vec3& normal : moved.normals) normal = motion.normal(normal);
    moved.area *= motion.scale * motion.scale;
    const LocalFeatures a = features_of(surface, {1.0, 2.0});
    const LocalFeatures b = features_of(moved, {7.0, 14.0});
    ASSERT_EQ(a.features.size(), 80U);
    ASSERT_EQ(b.features.size(), a.features.size());
    for (std::size_t i = 0; i < a.features.size(); ++i) {
        for (std::size_t k = 0; k < LocalFeature::kBytes; ++k) {
            EXPECT_NEAR(a.features[i].values[k], b.features[i].values[k], 1);
        }
    }
}

TEST(LocalFeatures, HillsAndHollowsDifferAndTurningOverSwapsThem) {
    SurfacePoints ball = surface_points(test::icosphere_mesh({0, 0, 0}, 1.0, 4));
    const LocalFeatures hill = features_of(ball, {0.7}, 1);
    for (Vec3& normal : ball.normals) normal = -normal;
    const LocalFeatures hollow = features_of(ball, {0.7}, 1);
    EXPECT_GT(squared_distance(hill.at(0, 0), hollow.at(0, 0)), 2000);
    EXPECT_LT(squared_distance(turned_over(hill.at(0, 0)), hollow.at(0, 0)), 50);
}

TEST(LocalFeatures, PointsAreSpread) {
    const LocalFeatures features = features_of(surface_points(odd_body()), {1.0}, 30);
    for (std::size_t a = 0; a < features.points.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_GT((features.points[a] - features.points[b]).norm(), 0.8);
        }
    }
}

TEST(FeatureCandidates, PlaceAPieceInItsWhole) {
    // A limb with its branch off, the rest of the body being out of sight.
    const mesh::TriangleMesh whole =
        test::merged(odd_body(), test::merged(test::icosphere_mesh({-2, 0, 0}, 2.5, 3),
                                              test::capsule_mesh({-3, 0, 0}, {-9, 6, 2}, 1.2)));
    const SurfacePoints target = surface_points(whole, {.count = 8192});
    const NearestPoint nearest(target.points);
    Similarity motion{0.3, test::random_rotation(8), Vec3(9, 8, 7)};
    const mesh::TriangleMesh piece =
        test::transformed(odd_body(), motion.scale * motion.rotation, motion.translation);
    const SurfacePoints source = surface_points(piece, {.count = 2048});
    const auto candidates = feature_candidates(
        features_of(source, {0.3, 0.45}, 48), features_of(target, {0.8, 1.0, 1.25, 1.56}, 300),
        source.diagonal, {.kind = {.scale = true}, .least_scale = 1.0, .most_scale = 10.0});
    ASSERT_FALSE(candidates.empty());
    double best = 1e300;
    for (const FeatureCandidate& candidate : candidates) {
        EXPECT_GE(candidate.votes, candidates.back().votes);
        const Refined refined =
            refine(thinned_out(source, 300), target, nearest, candidate.placement, {.scale = true});
        const Vec3 corner(2, 5, 1);
        best = std::min(best, (refined.placement.point(motion.point(corner)) - corner).norm());
    }
    EXPECT_LT(best, 0.1);
}

}  // namespace
}  // namespace ossuary::registration
