#include "engine/registration/piece_search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/registration/odd_body.h"
#include "tests/support/shapes.h"

namespace ossuary::registration {
namespace {

/// The odd body as a limb of something larger.
mesh::TriangleMesh whole_with_odd_body() {
    mesh::TriangleMesh rest = test::icosphere_mesh({-2, 0, 0}, 2.5, 3);
    rest = test::merged(rest, test::capsule_mesh({-3, 0, 0}, {-9, 6, 2}, 1.2));
    return test::merged(odd_body(), rest);
}

/// What of a mesh lies beyond a plane across x, turned, scaled and moved.
mesh::TriangleMesh beyond(const mesh::TriangleMesh& whole, double x, const Similarity& motion) {
    mesh::TriangleMesh piece = whole;
    std::erase_if(piece.triangles,
                  [&](const auto& triangle) { return whole.vertices[triangle[0]].x() < x; });
    piece.face_of_triangle.resize(piece.triangles.size());
    return test::transformed(piece, motion.scale * motion.rotation, motion.translation);
}

Similarity motion_of(std::uint64_t seed) {
    return {0.1 * static_cast<double>(seed), test::random_rotation(seed), Vec3(4, 5, 6)};
}

TEST(PlacePiece, LaysAnOpenPieceWhereItWasCutFrom) {
    const mesh::TriangleMesh whole = whole_with_odd_body();
    const WholeFeatures features = whole_features(whole);
    const WholeSurface surface(whole);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Similarity motion = motion_of(seed);
        const auto placed = place_piece(piece_query(beyond(whole, 1.0, motion)), features, surface);
        ASSERT_TRUE(placed);
        EXPECT_NEAR(placed->placement.scale * motion.scale, 1.0, 0.01);
        const Vec3 tip(8, 1, 4);
        EXPECT_LT((placed->placement.point(motion.point(tip)) - tip).norm(), 0.15);
        EXPECT_GT(placed->explained, 0.95);
        EXPECT_LT(placed->distance, 0.1);
    }
}

TEST(PlacePiece, WhatClosesTheCutDoesNotCount) {
    const mesh::TriangleMesh whole = whole_with_odd_body();
    const Similarity motion = motion_of(7);
    mesh::TriangleMesh piece = beyond(whole, 1.0, motion);
    mesh::TriangleMesh cap = test::box_mesh({0.99, -0.8, -0.8}, {1.0, 0.8, 0.8});
    piece = test::merged(
        piece, test::transformed(cap, motion.scale * motion.rotation, motion.translation));
    const auto placed = place_piece(piece_query(piece), whole_features(whole), WholeSurface(whole));
    ASSERT_TRUE(placed);
    EXPECT_NEAR(placed->placement.scale * motion.scale, 1.0, 0.02);
    EXPECT_LT(placed->distance, 0.15);
}

TEST(PlacePiece, IsFartherFromWhatItIsNoPieceOf) {
    const mesh::TriangleMesh whole = whole_with_odd_body();
    const mesh::TriangleMesh other = test::torus_mesh(3.0, 1.0);
    const PieceQuery piece = piece_query(beyond(whole, 1.0, motion_of(2)));
    const auto placed = place_piece(piece, whole_features(other), WholeSurface(other));
    EXPECT_TRUE(!placed || placed->distance > 0.3);
}

TEST(PlacePiece, NothingWithoutAreaIsPlaced) {
    const mesh::TriangleMesh body = odd_body();
    mesh::TriangleMesh flat;
    flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    flat.triangles = {{0, 1, 2}};
    flat.face_of_triangle = {0};
    flat.face_count = 1;
    EXPECT_FALSE(place_piece(piece_query(flat), whole_features(body), WholeSurface(body)));
    const WholeFeatures none = whole_features(flat);
    EXPECT_TRUE(none.features.points.empty());
    EXPECT_FALSE(place_piece(piece_query(body), none, WholeSurface(flat)));
}

TEST(PieceLikeness, IsGreatestForTheWholeThatHasThePiece) {
    const mesh::TriangleMesh whole = whole_with_odd_body();
    const PieceQuery piece = piece_query(beyond(whole, 1.0, motion_of(3)));
    std::vector<std::vector<std::uint16_t>> nearest;
    for (const mesh::TriangleMesh& mesh :
         {test::torus_mesh(3.0, 1.0), whole, test::box_mesh({0, 0, 0}, {1, 2, 5}),
          test::icosphere_mesh({0, 0, 0}, 1.0, 3), test::torus_mesh(3.0, 0.3)}) {
        nearest.push_back(nearest_features(piece, whole_features(mesh)));
    }
    const std::vector<double> likeness = piece_likeness(nearest);
    EXPECT_EQ(std::max_element(likeness.begin(), likeness.end()) - likeness.begin(), 1);
    EXPECT_EQ(likeness[1], 1.0);
    EXPECT_TRUE(piece_likeness({}).empty());
}

}  // namespace
}  // namespace ossuary::registration
