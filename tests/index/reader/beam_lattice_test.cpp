#include "index/reader/beam_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "engine/core/whole_file.h"
#include "engine/mesh/components.h"
#include "engine/mesh/measures.h"
#include "engine/skeleton/skeletonize.h"
#include "index/model_reader.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

constexpr double kPi = std::numbers::pi;

double volume(const std::vector<Vec3>& nodes, const std::vector<Beam>& beams) {
    const auto surface = beam_lattice_surface(nodes, beams, {});
    EXPECT_TRUE(surface);
    return mesh::measure(*surface).signed_volume;
}

Beam strut(BeamCap cap, double first, double second) {
    return {{0, 1}, {first, second}, {cap, cap}};
}

TEST(BeamLattice, HasTheVolumeOfItsSolids) {
    const std::vector<Vec3> nodes = {{1, 2, 3}, {1, 5, 7}};  // 5 apart
    const auto ball = [](double radius) { return 4.0 / 3.0 * kPi * radius * radius * radius; };
    EXPECT_NEAR(volume(nodes, {strut(BeamCap::kButt, 1, 1)}), kPi * 5, 1e-9);
    // A cone's frustum.
    EXPECT_NEAR(volume(nodes, {strut(BeamCap::kButt, 1, 2)}), kPi * 5 * (1 + 2 + 4) / 3, 1e-9);
    EXPECT_NEAR(volume(nodes, {strut(BeamCap::kHemisphere, 1, 1)}), kPi * 5 + ball(1), 0.1);
    // Balls are surfaces of their own, which overlap the strut's.
    EXPECT_NEAR(volume(nodes, {strut(BeamCap::kSphere, 1, 2)}), kPi * 5 * 7 / 3 + ball(1) + ball(2),
                0.8);
}

TEST(BeamLattice, HasOneBallANodeTheLargest) {
    const std::vector<Vec3> nodes = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
    const std::vector<Beam> beams = {
        {{0, 1}, {1, 1}, {BeamCap::kSphere, BeamCap::kButt}},
        {{2, 0}, {1, 2}, {BeamCap::kButt, BeamCap::kSphere}},
    };
    const auto surface = beam_lattice_surface(nodes, beams, {});
    ASSERT_TRUE(surface);
    EXPECT_EQ(mesh::connected_components(*surface).count, 3u);
    EXPECT_NEAR(mesh::measure(*surface).bounds.min().x(), -2.0, 0.05);
}

TEST(BeamLattice, LeavesTheBallOfAStrutWithoutLength) {
    const auto surface = beam_lattice_surface(std::vector<Vec3>{{1, 1, 1}, {1, 1, 1}},
                                              std::vector{strut(BeamCap::kSphere, 1, 2)}, {});
    ASSERT_TRUE(surface);
    EXPECT_NEAR(mesh::measure(*surface).bounds.sizes().z(), 4.0, 1e-9);
}

TEST(BeamLattice, TakesFewerSidesWhereThereAreManyAndRefusesTooMany) {
    const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0}};
    const std::vector<Beam> few(10, strut(BeamCap::kButt, 0.1, 0.1));
    const std::vector<Beam> many(30'000, strut(BeamCap::kButt, 0.1, 0.1));
    EXPECT_EQ(beam_lattice_surface(nodes, few, {})->triangles.size(), few.size() * 96);
    EXPECT_EQ(beam_lattice_surface(nodes, many, {})->triangles.size(), many.size() * 24);
    mesh::ReadMeshOptions caps;
    caps.max_faces = 100'000;
    EXPECT_EQ(beam_lattice_surface(nodes, many, caps).error().code, ErrorCode::kModelTooManyFaces);
    caps = {};
    caps.max_vertices = 100'000;
    EXPECT_EQ(beam_lattice_surface(nodes, many, caps).error().code,
              ErrorCode::kModelTooManyVertices);
}

TEST(BeamLattice, RefusesNodesAndRadiiThatAreNone) {
    const std::vector<Vec3> nodes = {{0, 0, 0}};
    const auto code = [&](const Beam& beam) {
        return beam_lattice_surface(nodes, std::vector{beam}, {}).error().code;
    };
    EXPECT_EQ(code(strut(BeamCap::kButt, 1, 1)), ErrorCode::kThreeMfInvalid);
    for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(code({{0, 0}, {1, radius}, {}}), ErrorCode::kThreeMfInvalid);
    }
}

/// The eight corners of a cube of 20 and its twelve edges as beams.
std::string cube_lattice(const std::string& attributes, const std::string& of_beams = "") {
    std::ostringstream text;
    text << R"(<model unit="millimeter" requiredextensions="b" )"
         << R"(xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02" )"
         << R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)"
         << R"(<object id="1" type="model"><mesh><vertices>)";
    for (int i = 0; i < 8; ++i) {
        text << "<vertex x=\"" << (i & 1) * 20 << "\" y=\"" << (i >> 1 & 1) * 20 << "\" z=\""
             << (i >> 2) * 20 << "\"/>";
    }
    text << "</vertices><triangles/><b:beamlattice " << attributes << "><b:beams>";
    for (int i = 0; i < 8; ++i) {
        for (const int bit : {1, 2, 4}) {
            if ((i & bit) != 0) continue;
            text << "<b:beam v1=\"" << i << "\" v2=\"" << (i | bit) << "\" " << of_beams << "/>";
        }
    }
    text << "</b:beams></b:beamlattice></mesh></object></resources>"
         << R"(<build><item objectid="1"/></build></model>)";
    return text.str();
}

Result<mesh::ReadMeshResult> read_part(const std::string& part) {
    const test::TemporaryFolder folder;
    ModelReader reader;
    return reader.read(test::write_three_mf(folder.path() / "lattice.3mf", part));
}

TEST(ThreeMfLattice, OfACubesEdgesHasTheSkeletonOfACubesEdges) {
    for (const char* cap : {"sphere", "hemisphere"}) {
        SCOPED_TRACE(cap);
        const auto read = read_part(
            cube_lattice("radius=\"1.5\" minlength=\"0.001\" cap=\"" + std::string(cap) + "\""));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_TRUE(read->warnings.empty());
        const auto skeleton = skeleton::skeletonize(read->mesh);
        ASSERT_TRUE(skeleton.ok()) << skeleton.error().message;
        EXPECT_EQ(skeleton->refined.nodes.size(), 8u);
        EXPECT_EQ(skeleton->refined.branches.size(), 12u);
        EXPECT_EQ(skeleton::topology(skeleton->refined), (skeleton::GraphTopology{1, 5}));
        for (const auto& node : skeleton->refined.nodes) EXPECT_EQ(node.degree, 3);
    }
}

TEST(ThreeMfLattice, TakesRadiiAndCapsFromTheBeamElseFromTheLattice) {
    const double edges = 12 * 20;
    const auto all = read_part(cube_lattice("radius=\"2\" minlength=\"0.001\" cap=\"butt\""));
    ASSERT_TRUE(all) << all.error().message;
    EXPECT_NEAR(mesh::measure(all->mesh).signed_volume, edges * kPi * 4, 1e-3);
    const auto own = read_part(cube_lattice("radius=\"2\" minlength=\"0.001\" cap=\"sphere\"",
                                            R"(r1="1" r2="1" cap1="butt" cap2="butt")"));
    ASSERT_TRUE(own) << own.error().message;
    EXPECT_NEAR(mesh::measure(own->mesh).signed_volume, edges * kPi, 1e-3);
    // The second radius follows the first; balls where nothing is said of caps.
    const auto first = read_part(cube_lattice("radius=\"2\" minlength=\"0.001\"", R"(r1="1")"));
    ASSERT_TRUE(first) << first.error().message;
    EXPECT_NEAR(mesh::measure(first->mesh).signed_volume, edges * kPi + 8 * 4.0 / 3.0 * kPi, 2.0);
}

}  // namespace
}  // namespace ossuary::index
