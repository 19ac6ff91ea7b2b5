#include "engine/mesh/read_off.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/mesh/measures.h"
#include "engine/mesh/write_mesh.h"
#include "tests/engine/mesh/built_meshes.h"
#include "tests/engine/mesh/model_corpus.h"

namespace ossuary::test {
namespace {

const std::string kTriangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string code_of(const std::string& text, const mesh::ReadMeshOptions& options) {
    const Result<mesh::ReadMeshResult> read = mesh::read_off(text, "model", options);
    return read ? "ok" : std::string(to_string(read.error().code));
}

TEST(ReadOff, ReadsPositionsExactly) {
    const auto read = mesh::read_off(
        "OFF\n3 1 0\n0.1 -2.5e-3 1e22\n123456789.123456789 .3 7\n1 2 3.0000000000000004\n3 2 1 0\n",
        "model");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices[0], Vec3(0.1, -2.5e-3, 1e22));
    EXPECT_EQ(read->mesh.vertices[1], Vec3(123456789.123456789, .3, 7));
    EXPECT_EQ(read->mesh.vertices[2], Vec3(1, 2, 3.0000000000000004));
    EXPECT_EQ(read->mesh.triangles[0], (mesh::TriangleMesh::Triangle{2, 1, 0}));
}

TEST(ReadOff, SkipsNormalsColorsAndTextureCoordinatesWithoutTakingThemForPositions) {
    for (const auto& model_case : model_cases("off", "ok")) {
        if (model_case.vertices != 3 || model_case.bytes.find("OFF") == std::string::npos) continue;
        if (model_case.name.find("off") == std::string::npos) continue;
        const auto read = mesh::read_off(model_case.bytes, model_case.name);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->mesh.vertices[0], Vec3(0, 0, 0)) << model_case.name;
        EXPECT_EQ(read->mesh.vertices[1], Vec3(1, 0, 0)) << model_case.name;
        EXPECT_EQ(read->mesh.vertices[2], Vec3(0, 1, 0)) << model_case.name;
    }
}

TEST(ReadOff, HoldsEachCapExactly) {
    mesh::ReadMeshOptions options;
    options.max_vertices = 3;
    options.max_faces = 1;
    options.max_face_corners = 3;
    options.max_triangles = 1;
    EXPECT_EQ(code_of(kTriangle, options), "ok");
    options.max_vertices = 2;
    EXPECT_EQ(code_of(kTriangle, options), "off_too_many_vertices");
    options.max_vertices = 3;
    options.max_faces = 0;
    EXPECT_EQ(code_of(kTriangle, options), "off_too_many_faces");
    options.max_faces = 1;
    options.max_face_corners = 2;
    EXPECT_EQ(code_of(kTriangle, options), "off_too_many_corners");
    options.max_face_corners = 3;
    options.max_triangles = 0;
    EXPECT_EQ(code_of(kTriangle, options), "off_too_many_faces");
    options.max_triangles = 1;
    options.max_coordinate = 1;
    EXPECT_EQ(code_of(kTriangle, options), "ok");
    options.max_coordinate = 0.5;
    EXPECT_EQ(code_of(kTriangle, options), "mesh_scale");
}

TEST(ReadOff, DoesNotAllocateWhatTheCountsPromiseWhenCapsAreRaised) {
    mesh::ReadMeshOptions options;
    options.max_vertices = 4'294'967'295u;
    options.max_faces = 4'294'967'295u;
    // 100 GB of vertices, were they believed.
    EXPECT_EQ(code_of("4294967295 4294967295 0\n0 0 0\n", options), "off_truncated");
}

TEST(ReadOff, TriangulatesPolygonsWithoutLosingArea) {
    const std::map<std::string, double> areas = {
        {"quad_convex", 1.0},          {"quad_concave_dart", 6.0},
        {"polygon_l_shape", 3.0},      {"polygon_comb", 22.5},
        {"cube_of_quads", 6.0},        {"polygon_with_straight_corners", 4.0},
        {"polygon_bridged_hole", 32.0}};
    std::size_t seen = 0;
    for (const auto& model_case : model_cases("off", "ok")) {
        const auto expected = areas.find(model_case.name);
        if (expected == areas.end()) continue;
        ++seen;
        const auto read = mesh::read_off(model_case.bytes, model_case.name);
        ASSERT_TRUE(read) << read.error().message;
        // No area twice, none outside: the sum of the parts is the whole only if none overlap.
        EXPECT_NEAR(mesh::measure(read->mesh).surface_area, expected->second, 1e-12)
            << model_case.name;
    }
    EXPECT_EQ(seen, areas.size());
}

TEST(ReadOff, NumbersTheSourceFaceOfEachTriangle) {
    const auto read = mesh::read_off(
        "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 2\n4 0 1 2 3\n2 0 1\n3 0 1 4\n5 0 1 2 4 3\n",
        "model");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.face_count, 4u);
    EXPECT_EQ(read->mesh.face_of_triangle, (std::vector<std::uint32_t>{0, 0, 2, 3, 3, 3}));
}

TEST(ReadOff, GivesACodedErrorOrAMeshForEveryTruncationOfEveryGoodFile) {
    for (const auto& model_case : model_cases("off", "ok")) {
        for (std::size_t length = 0; length < model_case.bytes.size(); ++length) {
            const auto read = mesh::read_off(model_case.bytes.substr(0, length), model_case.name);
            if (read) {
                ASSERT_EQ(read->mesh.vertices.size(), model_case.vertices) << model_case.name;
                ASSERT_LE(read->mesh.triangles.size(), model_case.triangles) << model_case.name;
            } else {
                ASSERT_NE(read.error().message.find("line "), std::string::npos);
                const std::string code(to_string(read.error().code));
                ASSERT_EQ(code.rfind("off_", 0), 0u) << code;
            }
        }
    }
}

TEST(ReadOff, FindsEveryTruncationThatCutsOffALine) {
    const std::string text = mesh::to_off(torus_mesh(6, 5));
    std::size_t lines = 0;
    for (std::size_t end = text.find('\n'); end + 1 < text.size(); end = text.find('\n', end + 1)) {
        ++lines;
        const auto read = mesh::read_off(text.substr(0, end), "model");
        ASSERT_FALSE(read) << "cut after line " << lines;
        const ErrorCode code = read.error().code;
        EXPECT_TRUE(code == ErrorCode::kOffTruncated ||
                    (lines < 2 && code == ErrorCode::kOffCounts));
    }
    EXPECT_EQ(lines, 1u + 30 + 60);
}

TEST(ReadOff, SurvivesRandomDamage) {
    std::mt19937_64 random(7);
    const std::string alphabet = "0123456789-+.eE#\n\r \tOFFnan\x80\xff/,";
    for (const auto& model_case : model_cases("off", "ok")) {
        for (int round = 0; round < 200; ++round) {
            std::string text = model_case.bytes;
            const std::size_t changes = 1 + random() % 4;
            for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
                const std::size_t at = random() % text.size();
                switch (random() % 4) {
                    case 0:
                        text[at] = alphabet[random() % alphabet.size()];
                        break;
                    case 1:
                        text.insert(at, 1, alphabet[random() % alphabet.size()]);
                        break;
                    case 2:
                        text.erase(at, 1 + random() % 5);
                        break;
                    default:
                        text.insert(at, text.substr(random() % text.size(), random() % 20));
                }
            }
            const auto read = mesh::read_off(text, model_case.name);
            if (!read) continue;
            for (const auto& triangle : read->mesh.triangles) {
                for (const auto vertex : triangle) ASSERT_LT(vertex, read->mesh.vertices.size());
            }
            for (const Vec3& vertex : read->mesh.vertices) ASSERT_TRUE(vertex.allFinite());
            ASSERT_EQ(read->mesh.face_of_triangle.size(), read->mesh.triangles.size());
        }
    }
}

TEST(ReadOff, SurvivesRandomBytes) {
    std::mt19937_64 random(8);
    for (int round = 0; round < 500; ++round) {
        std::string text = round % 2 == 0 ? "OFF\n" : "";
        for (std::size_t i = random() % 300; i > 0; --i) {
            text += static_cast<char>(1 + random() % 255);
        }
        const auto read = mesh::read_off(text, "noise");
        if (read) continue;
        EXPECT_EQ(std::string(to_string(read.error().code)).rfind("off_", 0), 0u);
    }
}

TEST(ReadOff, StopsLookingForEarsWhereAHostileFileAsksForTooMuch) {
    // Zigzags of 10,000 corners make ear clipping quadratic; the work over a file is bounded, and
    // what comes after that is cut as fans.
    const int corners = 10'000;
    const int polygons = 20;
    std::string text = "OFF\n" + std::to_string(corners) + " " + std::to_string(polygons) + " 0\n";
    for (int i = 0; i < corners; ++i) {
        const int tooth = i < corners / 2 ? i : corners - 1 - i;
        const int y = (i < corners / 2 ? 0 : 1) + 4 * (tooth % 2);
        text += std::to_string(tooth) + " " + std::to_string(y) + " 0\n";
    }
    std::string face = std::to_string(corners);
    for (int i = 0; i < corners; ++i) face.append(1, ' ').append(std::to_string(i));
    for (int i = 0; i < polygons; ++i) text += face + "\n";
    const auto read = mesh::read_off(text, "zigzag");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.triangles.size(), std::size_t(polygons * (corners - 2)));
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_EQ(read->warnings[0].code, "polygons_without_ears");
    EXPECT_GE(read->warnings[0].count, std::size_t(polygons / 2));
    EXPECT_LT(read->warnings[0].count, std::size_t(polygons)) << "the first is cut properly";
}

}  // namespace
}  // namespace ossuary::test
