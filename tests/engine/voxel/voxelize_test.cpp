#include "engine/voxel/voxelize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/voxel/betti.h"
#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

using test::MeshShape;

VoxelSolid solid_of(const mesh::TriangleMesh& mesh, const VoxelizeOptions& options = {}) {
    auto solid = voxelize(mesh, options);
    EXPECT_TRUE(solid.ok()) << (solid.ok() ? "" : solid.error().message);
    return solid.ok() ? std::move(*solid) : VoxelSolid{};
}

std::size_t warned(const VoxelSolid& solid, const std::string& code) {
    std::size_t count = 0;
    for (const mesh::MeshWarning& w : solid.warnings) count += w.code == code ? w.count : 0;
    return count;
}

/// The winding number by solid angles (van Oosterom & Strackee, 1983): shares nothing with lines
/// through voxels.
double winding_number(const mesh::TriangleMesh& mesh, const Vec3& p) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corners = mesh.corners(t);
        const Vec3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum += 2 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4 * std::numbers::pi);
}

double overlap(const BitVolume& a, const BitVolume& b) {
    EXPECT_EQ(a.size(), b.size());
    std::size_t both = 0;
    for (std::size_t w = 0; w < a.words().size(); ++w) {
        both += static_cast<std::size_t>(std::popcount(a.words()[w] & b.words()[w]));
    }
    return static_cast<double>(both) / static_cast<double>(a.count() + b.count() - both);
}

bool has_empty_border(const BitVolume& volume) {
    bool empty = true;
    for_each_voxel(volume, [&](const Vec3i& v) {
        empty = empty && v.minCoeff() > 0 && (volume.size() - v).minCoeff() > 1;
    });
    return empty;
}

TEST(Voxelize, SetsExactlyTheVoxelsWhoseCentreIsInside) {
    for (const MeshShape& shape : test::mesh_shapes()) {
        // Turned, so that no centre lies on a face, where either answer is right.
        const mesh::TriangleMesh mesh = test::transformed(shape.mesh, test::random_rotation(7));
        const VoxelSolid solid = solid_of(mesh, {.resolution = 24, .fill_cavities = false});
        std::size_t wrong = 0;
        // Every third voxel of a row, shifted from row to row.
        for (int z = 0; z < solid.volume.size().z(); ++z) {
            for (int y = z % 2; y < solid.volume.size().y(); y += 2) {
                for (int x = (y / 2 + z) % 3; x < solid.volume.size().x(); x += 3) {
                    const Vec3 centre = solid.world_from_grid.point({x + .5, y + .5, z + .5});
                    const bool inside = std::abs(winding_number(mesh, centre)) > 0.5;
                    wrong += inside != solid.volume.test(x, y, z);
                }
            }
        }
        EXPECT_EQ(wrong, 0u) << shape.name;
        EXPECT_EQ(solid.method, "winding") << shape.name;
        EXPECT_TRUE(has_empty_border(solid.volume)) << shape.name;
    }
}

TEST(Voxelize, FillsAnAlignedBoxToTheVoxel) {
    for (const int side : {8, 16, 64, 100}) {
        const VoxelSolid solid =
            solid_of(test::box_mesh({0, 0, 0}, {4, 2, 1}), {.resolution = side});
        EXPECT_EQ(solid.volume.count(), static_cast<std::size_t>(side) *
                                            static_cast<std::size_t>(std::lround(side / 2.0)) *
                                            static_cast<std::size_t>(std::lround(side / 4.0)))
            << side;
    }
}

TEST(Voxelize, KeepsTheTopologyOfATorusInEveryPose) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const VoxelSolid solid = solid_of(
            test::transformed(test::torus_mesh(3, 0.6, 48, 20), test::random_rotation(seed)),
            {.resolution = 24 + static_cast<int>(seed)});
        ASSERT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 1, 0})) << seed;
    }
}

TEST(Voxelize, GivesTheTopologyOfTheSolid) {
    for (const MeshShape& shape : test::mesh_shapes()) {
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            const VoxelSolid solid =
                solid_of(test::transformed(shape.mesh, test::random_rotation(seed)));
            EXPECT_EQ(betti_numbers(solid.volume), shape.betti) << shape.name << " " << seed;
        }
    }
}

TEST(Voxelize, DoesNotDependOnTheOrderOfTheMesh) {
    std::vector<mesh::TriangleMesh> meshes;
    for (const MeshShape& shape : test::mesh_shapes()) {
        meshes.push_back(shape.mesh);
        meshes.push_back(test::without_some_triangles(shape.mesh, 0.1, 3));
    }
    // Doubled triangles, some of them facing the other way.
    meshes.push_back(test::merged(meshes[2], test::flipped(meshes[3])));
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const mesh::TriangleMesh mesh = test::transformed(meshes[i], test::random_rotation(i));
        const VoxelSolid solid = solid_of(mesh, {.resolution = 40});
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            const VoxelSolid again = solid_of(test::renumbered(mesh, seed), {.resolution = 40});
            EXPECT_EQ(again.volume, solid.volume) << i;
            EXPECT_EQ(again.method, solid.method) << i;
        }
    }
}

TEST(Voxelize, DoesNotDependOnPlaceOrSize) {
    // Coordinates on a coarse grid, so that moving and scaling them is exact.
    mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    for (Vec3& v : mesh.vertices) v = (v * 1024).array().round() / 1024;
    const BitVolume volume = solid_of(mesh).volume;
    for (const double scale : {0x1p-100, 0x1p-3, 0x1p+100}) {
        EXPECT_EQ(solid_of(test::transformed(mesh, scale * Mat3::Identity())).volume, volume);
    }
    EXPECT_EQ(solid_of(test::transformed(mesh, Mat3::Identity(), {1000, -77, 4096})).volume,
              volume);
}

TEST(Voxelize, PlacesTheGridOverTheModel) {
    const Mat3 pose = test::random_rotation(5);
    const mesh::TriangleMesh mesh =
        test::transformed(test::torus_mesh(3, 1), Mat3::Identity(), {9, 8, 7});
    for (const Mat3& rotation : {Mat3(Mat3::Identity()), pose}) {
        const VoxelSolid solid = solid_of(mesh, {.resolution = 50, .rotation = rotation});
        Box3 bounds;
        for (const Vec3& v : mesh.vertices) bounds.extend(solid.world_from_grid.grid(v));
        EXPECT_NEAR(bounds.sizes().maxCoeff(), 50, 1e-9);
        EXPECT_GE(bounds.min().minCoeff(), 2 - 1e-9);
        EXPECT_LE((bounds.max() - solid.volume.size().cast<double>()).maxCoeff(), -2 + 1e-9);
        Vec3 mean = Vec3::Zero();
        for_each_voxel(solid.volume, [&](const Vec3i& v) {
            mean += solid.world_from_grid.point(v.cast<double>() + Vec3::Constant(0.5));
        });
        mean /= static_cast<double>(solid.volume.count());
        EXPECT_LT((mean - Vec3(9, 8, 7)).norm(), 0.05);
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(solid.world_from_grid.rotation.col(i), rotation.col(i));
        }
    }
}

TEST(Voxelize, ARotatedGridEqualsARotatedModel) {
    const Mat3 pose = test::random_rotation(11);
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    EXPECT_EQ(solid_of(mesh, {.rotation = pose}).volume,
              solid_of(test::transformed(mesh, pose.transpose())).volume);
}

TEST(Voxelize, AMirroredGridEqualsAMirroredModel) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
    const VoxelSolid solid = solid_of(mesh, {.rotation = mirror});
    EXPECT_EQ(solid.volume, solid_of(test::transformed(mesh, mirror)).volume);
    // The box sits in the middle of its cells: but for centres on the surface, the same voxels.
    EXPECT_GT(overlap(test::mirrored(solid.volume, 0), solid_of(mesh).volume), 0.999);
}

TEST(Voxelize, UnitesOverlappingAndNestedPartsWhicheverWayTheyFace) {
    const mesh::TriangleMesh a = test::icosphere_mesh({0, 0, 0}, 1);
    const mesh::TriangleMesh b = test::icosphere_mesh({0.9, 0.3, 0.1}, 0.7);
    const mesh::TriangleMesh c = test::icosphere_mesh({0.1, 0, 0}, 0.5);
    const auto all = [&](bool fa, bool fb, bool fc) {
        return test::merged(test::merged(fa ? test::flipped(a) : a, fb ? test::flipped(b) : b),
                            fc ? test::flipped(c) : c);
    };
    const VoxelSolid solid = solid_of(all(false, false, false), {.resolution = 48});
    EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 0, 0}));
    for_each_voxel(solid.volume, [&](const Vec3i& v) {
        const Vec3 p = solid.world_from_grid.point(v.cast<double>() + Vec3::Constant(0.5));
        ASSERT_TRUE(p.norm() < 1 || (p - Vec3(0.9, 0.3, 0.1)).norm() < 0.7);
    });
    for (int code = 1; code < 8; ++code) {
        const VoxelSolid turned = solid_of(all(code & 1, code & 2, code & 4), {.resolution = 48});
        EXPECT_EQ(turned.volume, solid.volume) << code;
    }
}

TEST(Voxelize, TakesTrianglesThatFaceEitherWay) {
    mesh::TriangleMesh mesh = test::transformed(test::torus_mesh(3, 1), test::random_rotation(1));
    const BitVolume volume = solid_of(mesh).volume;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
    }
    EXPECT_EQ(solid_of(mesh).volume, volume);
    EXPECT_EQ(solid_of(mesh).method, "winding");
    // Both sides modelled.
    EXPECT_EQ(solid_of(test::merged(mesh, test::flipped(mesh))).volume, volume);
}

TEST(Voxelize, WeldsSeparatePolygons) {
    const mesh::TriangleMesh mesh =
        test::transformed(test::torus_mesh(3, 1), test::random_rotation(2));
    mesh::TriangleMesh soup;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const Vec3& corner : mesh.corners(t)) soup.vertices.push_back(corner);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    soup.face_of_triangle = mesh.face_of_triangle;
    soup.face_count = mesh.face_count;
    EXPECT_EQ(solid_of(soup).volume, solid_of(mesh).volume);
}

TEST(Voxelize, MakesAnOpenBoxTheSameSolidAsAClosedOne) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Mat3 pose = seed == 0 ? Mat3(Mat3::Identity()) : test::random_rotation(seed);
        const Vec3 high(3, 2, 1 + 0.5 * static_cast<double>(seed % 4));
        const VoxelSolid closed =
            solid_of(test::transformed(test::box_mesh({0, 0, 0}, high), pose));
        const VoxelSolid open =
            solid_of(test::transformed(test::open_box_mesh({0, 0, 0}, high), pose));
        EXPECT_GE(overlap(open.volume, closed.volume), 0.97) << seed;
        EXPECT_EQ(betti_numbers(open.volume), (BettiNumbers{1, 0, 0})) << seed;
        EXPECT_EQ(open.method, "voting");
        EXPECT_EQ(warned(open, "open_surface"), 10u);
        EXPECT_EQ(warned(closed, "open_surface"), 0u);
    }
}

TEST(Voxelize, SurvivesMissingTriangles) {
    for (const MeshShape& shape : test::mesh_shapes()) {
        if (shape.mesh.triangles.size() < 100) continue;
        const mesh::TriangleMesh mesh = test::transformed(shape.mesh, test::random_rotation(3));
        const BitVolume whole = solid_of(mesh).volume;
        for (const double share : {0.02, 0.1}) {
            const VoxelSolid holed = solid_of(test::without_some_triangles(mesh, share, 17));
            EXPECT_GE(overlap(holed.volume, whole), 0.96) << shape.name << " " << share;
        }
    }
}

TEST(Voxelize, MakesAFlatPlateOneVoxelThick) {
    for (const double thickness : {0.0, 1e-9, 0.01}) {
        const VoxelSolid solid = solid_of(test::box_mesh({0, 0, 0}, {4, 3, thickness}));
        EXPECT_EQ(solid.volume.count(), 96u * 72u) << thickness;
        EXPECT_EQ(solid.volume.size().z(), 5) << thickness;
    }
}

TEST(Voxelize, KeepsATiltedPlateWhole) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const double thickness : {0.0, 0.01, 0.03, 0.05, 0.08}) {  // up to 1.9 voxels
            const VoxelSolid solid = solid_of(test::transformed(
                test::box_mesh({0, 0, 0}, {4, 3, thickness}), test::random_rotation(seed)));
            EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 0, 0}))
                << seed << " " << thickness;
            // At least one layer, seen along the axis that it faces most, and at most three.
            const double area = 12 / std::pow(solid.world_from_grid.voxel_size, 2);
            EXPECT_GT(static_cast<double>(solid.volume.count()), 0.55 * area) << thickness;
            EXPECT_LT(static_cast<double>(solid.volume.count()), 3 * area) << thickness;
        }
    }
}

TEST(Voxelize, SamplesAtCentresOnlyWhenAsked) {
    const mesh::TriangleMesh mesh = test::merged(
        test::icosphere_mesh({0, 0, 0}, 1), test::capsule_mesh({0.9, 0, 0}, {3, 0.5, 1}, 0.002, 8));
    VoxelizeOptions sampling = {.resolution = 64};
    sampling.keep_thin_parts = sampling.fill_cavities = sampling.close_small_tunnels = false;
    sampling.bridge_gap = 0;
    sampling.min_component_extent = 0;
    const VoxelSolid solid = solid_of(mesh, sampling);
    EXPECT_EQ(warned(solid, "thin_parts"), 0u);
    std::size_t inside = 0;
    for (int z = 0; z < solid.volume.size().z(); ++z) {
        for (int y = 0; y < solid.volume.size().y(); ++y) {
            for (int x = 0; x < solid.volume.size().x(); ++x) {
                const Vec3 centre = solid.world_from_grid.point(Vec3(x + 0.5, y + 0.5, z + 0.5));
                if (centre.norm() < 0.99 && !solid.volume.test(x, y, z)) ADD_FAILURE() << centre;
                if (solid.volume.test(x, y, z) && centre.norm() < 1) ++inside;
            }
        }
    }
    EXPECT_GT(inside, solid.volume.count() - 40);
    const mesh::TriangleMesh sheet =
        test::transformed(test::box_mesh({0, 0, 0}, {4, 3, 1e-7}), test::random_rotation(1));
    const auto nothing = voxelize(sheet, sampling);
    ASSERT_FALSE(nothing.ok());
    EXPECT_EQ(nothing.error().code, ErrorCode::kSolidEmpty);
}

TEST(Voxelize, TakesAClosedMeshAsItComes) {
    // Two boxes that share the place of an edge but no vertex, one inside out: to weld them would
    // make one part of winding numbers 1 and -1.
    const mesh::TriangleMesh two = test::merged(
        test::box_mesh({0, 0, 0}, {1, 1, 1}), test::flipped(test::box_mesh({1, 1, 0}, {2, 2, 1})));
    EXPECT_EQ(solid_of(two, {.resolution = 32}).volume.count(), 2u * 16 * 16 * 16);
    // A box twice over, face by face: repeated triangles are told and left out.
    mesh::TriangleMesh twice = test::box_mesh({0, 0, 0}, {1, 1, 1});
    const auto triangles = twice.triangles;
    for (const auto& [a, b, c] : triangles) twice.triangles.push_back({a, c, b});
    const VoxelSolid solid = solid_of(twice, {.resolution = 32});
    EXPECT_EQ(solid.volume.count(), 32u * 32 * 32);
    EXPECT_EQ(warned(solid, "repeated_triangles"), triangles.size());
}

TEST(Voxelize, KeepsWiresAndAntennae) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const mesh::TriangleMesh mesh =
            test::transformed(test::merged(test::icosphere_mesh({0, 0, 0}, 1),
                                           test::capsule_mesh({0.9, 0, 0}, {3, 0.5, 1}, 0.002, 8)),
                              test::random_rotation(seed));
        const VoxelSolid solid = solid_of(mesh, {.resolution = 64});
        EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 0, 0})) << seed;
        EXPECT_GT(warned(solid, "thin_parts"), 10u);
        const Vec3 tip = test::random_rotation(seed) * Vec3(3, 0.5, 1);
        const Vec3i voxel = solid.world_from_grid.grid(tip).array().floor().cast<int>();
        double nearest = 1e9;
        for_each_voxel(solid.volume, [&](const Vec3i& v) {
            nearest = std::min(nearest, (v - voxel).cast<double>().norm());
        });
        EXPECT_LE(nearest, 2.0) << seed;
    }
}

TEST(Voxelize, TakesDegenerateMeshes) {
    mesh::TriangleMesh triangle;
    triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}, {7, 7, 7}};
    triangle.triangles = {{0, 1, 2}};
    triangle.face_of_triangle = {0};
    triangle.face_count = 1;
    VoxelSolid solid = solid_of(triangle, {.resolution = 32});
    EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 0, 0}));
    EXPECT_EQ(solid.method, "surface");
    EXPECT_EQ(solid.volume.size().x(), 32 + 4);

    // A line: two corners of each triangle coincide.
    triangle.triangles = {{0, 1, 1}, {1, 2, 2}};
    triangle.face_of_triangle = {0, 1};
    solid = solid_of(triangle, {.resolution = 32});
    EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 0, 0}));
    EXPECT_LT(solid.volume.count(), 120u);

    // A needle of collinear corners.
    triangle.vertices[2] = {0.25, 0, 0};
    triangle.triangles = {{0, 1, 2}};
    triangle.face_of_triangle = {0};
    solid = solid_of(triangle, {.resolution = 32});
    EXPECT_EQ(solid.volume.count(), 32u);
}

TEST(Voxelize, TakesHugeAndTinyCoordinatesAndLongShapes) {
    const mesh::TriangleMesh mesh = test::torus_mesh(3, 1);
    for (const double scale : {1e-30, 1e30}) {
        const VoxelSolid solid = solid_of(test::transformed(mesh, scale * Mat3::Identity()));
        EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 1, 0})) << scale;
    }
    for (const double side : {1.0, 1e-3, 1e-12}) {
        const VoxelSolid solid =
            solid_of(test::transformed(test::box_mesh({0, 0, 0}, {1000, side, side}),
                                       test::random_rotation(9)),
                     {.resolution = 200});
        EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 0, 0})) << side;
        EXPECT_GE(solid.volume.count(), 199u) << side;
    }
}

TEST(Voxelize, RefusesWhatHasNoExtentAndOptionsOutOfRange) {
    const auto code = [](const mesh::TriangleMesh& mesh, const VoxelizeOptions& options = {}) {
        const auto result = voxelize(mesh, options);
        EXPECT_FALSE(result.ok());
        return result.ok() ? ErrorCode::kInternal : result.error().code;
    };
    const mesh::TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(code({}), ErrorCode::kMeshEmpty);
    EXPECT_EQ(code(test::box_mesh({1, 2, 3}, {1, 2, 3})), ErrorCode::kMeshNoExtent);
    EXPECT_EQ(code(box, {.resolution = 7}), ErrorCode::kInvalidArgument);
    EXPECT_EQ(code(box, {.resolution = 1025}), ErrorCode::kInvalidArgument);
    EXPECT_EQ(code(box, {.rotation = 2 * Mat3::Identity()}), ErrorCode::kInvalidArgument);
    EXPECT_EQ(code(box, {.rotation = Mat3::Ones()}), ErrorCode::kInvalidArgument);
    EXPECT_EQ(code(box, {.bridge_gap = 5}), ErrorCode::kInvalidArgument);
    mesh::TriangleMesh endless = box;
    endless.vertices[3].x() = std::numeric_limits<double>::infinity();
    EXPECT_EQ(code(endless), ErrorCode::kInvalidArgument);
    endless.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code(endless), ErrorCode::kInvalidArgument);
    EXPECT_EQ(code(test::box_mesh({-1e308, 0, 0}, {1e308, 1, 1})), ErrorCode::kInvalidArgument);
}

TEST(Voxelize, BridgesSmallGapsAndDropsSpecks) {
    const mesh::TriangleMesh a = test::box_mesh({0, 0, 0}, {10, 10, 10});
    const mesh::TriangleMesh near = test::box_mesh({10.15, 2, 2}, {20, 8, 8});
    const mesh::TriangleMesh speck = test::box_mesh({15, 15, 15}, {15.5, 15.5, 15.5});
    const mesh::TriangleMesh far = test::box_mesh({12, 12, 12}, {18, 18, 18});
    VoxelSolid solid = solid_of(test::merged(a, near));
    EXPECT_EQ(betti_numbers(solid.volume), (BettiNumbers{1, 0, 0}));
    EXPECT_EQ(warned(solid, "bridged_components"), 1u);
    solid = solid_of(test::merged(a, near), {.bridge_gap = 0});
    EXPECT_EQ(betti_numbers(solid.volume).components, 2);

    solid = solid_of(test::merged(test::merged(a, near), speck));
    EXPECT_EQ(betti_numbers(solid.volume).components, 1);
    EXPECT_EQ(warned(solid, "dropped_components"), 1u);

    solid = solid_of(test::merged(a, far));
    EXPECT_EQ(betti_numbers(solid.volume).components, 2);
    EXPECT_EQ(warned(solid, "several_components"), 2u);
}

/// The mesh with faces that have no area and a speck, all far away.
mesh::TriangleMesh with_far_faces(mesh::TriangleMesh mesh, const Vec3& place) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::uint32_t used = mesh.triangles[0][0];
    mesh.vertices.push_back(place);
    mesh.vertices.push_back((place + mesh.vertices[used]) / 2);
    mesh.vertices.push_back(2 * place);  // unused
    for (const mesh::TriangleMesh::Triangle& triangle :
         {mesh::TriangleMesh::Triangle{first, first, first},
          {used, first, first},
          {used, first, first + 1}}) {
        mesh.triangles.push_back(triangle);
        mesh.face_of_triangle.push_back(mesh.face_count++);
    }
    return test::merged(mesh, test::icosphere_mesh(1.5 * place, 1e-3, 1));
}

TEST(Voxelize, DoesNotChangeWithWhatLiesApart) {
    for (const MeshShape& shape : test::mesh_shapes()) {
        if (shape.mesh.triangles.size() < 100) continue;
        const mesh::TriangleMesh pose = test::transformed(shape.mesh, test::random_rotation(5));
        for (const mesh::TriangleMesh& mesh : {pose, test::without_some_triangles(pose, 0.1, 3)}) {
            const VoxelSolid solid = solid_of(mesh, {.resolution = 64});
            for (const double distance : {2.0, 20.0, 2000.0, 1e6}) {
                const VoxelSolid far =
                    solid_of(with_far_faces(mesh, 100 * distance * Vec3(0.6, -0.48, 0.64)),
                             {.resolution = 64});
                EXPECT_EQ(far.volume, solid.volume) << shape.name << " " << distance;
                EXPECT_EQ(far.world_from_grid.voxel_size, solid.world_from_grid.voxel_size);
                EXPECT_EQ(far.world_from_grid.origin, solid.world_from_grid.origin);
                EXPECT_EQ(far.method, solid.method);
                EXPECT_EQ(warned(far, "dropped_components"), 1u);
            }
        }
    }
}

TEST(Voxelize, LaysTheGridOverPiecesOfLikeSize) {
    const mesh::TriangleMesh ball = test::icosphere_mesh({0, 0, 0}, 1);
    const mesh::TriangleMesh two = test::merged(ball, test::icosphere_mesh({30, 0, 0}, 0.5));
    const VoxelSolid solid = solid_of(two);
    EXPECT_NEAR(solid.world_from_grid.voxel_size, 31.5 / 96, 1e-9);
    EXPECT_EQ(betti_numbers(solid.volume).components, 2);
    // A piece below a tenth of the larger one, unless all are asked for.
    const mesh::TriangleMesh small = test::merged(ball, test::icosphere_mesh({30, 0, 0}, 0.05));
    EXPECT_NEAR(solid_of(small).world_from_grid.voxel_size, 2.0 / 96, 1e-9);
    EXPECT_NEAR(solid_of(small, {.min_component_extent = 0}).world_from_grid.voxel_size, 31.05 / 96,
                1e-9);
    EXPECT_NEAR(solid_of(small, {.whole_mesh = true}).world_from_grid.voxel_size, 31.05 / 96, 1e-9);
}

TEST(Voxelize, DrawsNoLineOfFacesWithoutArea) {
    const mesh::TriangleMesh ball = test::icosphere_mesh({0, 0, 0}, 1);
    const mesh::TriangleMesh two = test::merged(ball, test::icosphere_mesh({4, 0, 0}, 1));
    mesh::TriangleMesh tied = two;
    tied.triangles.push_back({0, static_cast<std::uint32_t>(ball.vertices.size()), 0});
    tied.face_of_triangle.push_back(tied.face_count++);
    EXPECT_EQ(solid_of(tied).volume, solid_of(two).volume);
}

TEST(Voxelize, ClosesTheTunnelOfNearlyTouchingArms) {
    // A ring with a slit of half a voxel, crossed by a thin tie: two narrow tunnels of the grid.
    const mesh::TriangleMesh left = test::box_mesh({0, 0, 0}, {40, 10, 10});
    const mesh::TriangleMesh right = test::box_mesh({0, 11.5, 0}, {40, 21, 10});
    const mesh::TriangleMesh ties =
        test::merged(test::box_mesh({0, 9, 2}, {3, 13, 8}), test::box_mesh({6, 9, 2}, {8, 13, 8}));
    const mesh::TriangleMesh mesh = test::merged(test::merged(left, right), ties);
    EXPECT_EQ(betti_numbers(solid_of(mesh, {.resolution = 40, .close_small_tunnels = false}).volume)
                  .tunnels,
              1);
    const VoxelSolid closed = solid_of(mesh, {.resolution = 40});
    EXPECT_EQ(betti_numbers(closed.volume), (BettiNumbers{1, 0, 0}));
    EXPECT_GE(warned(closed, "closed_tunnels"), 1u);
    // A surface of its own handle keeps it, narrow as it may be.
    const VoxelSolid ring = solid_of(test::torus_mesh(3, 2.8), {.resolution = 40});
    EXPECT_EQ(betti_numbers(ring.volume), (BettiNumbers{1, 1, 0}));
}

}  // namespace
}  // namespace ossuary::voxel
