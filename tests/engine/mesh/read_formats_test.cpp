// What the readers of all formats must hold: caps, cancellation, and no faith in counts.

#include <gtest/gtest.h>

#include <functional>

#include "engine/mesh/read_mesh.h"
#include "engine/mesh/read_obj.h"
#include "engine/mesh/read_ply.h"
#include "engine/mesh/read_stl.h"
#include "engine/mesh/write_mesh.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

struct Format {
    std::string name;
    std::function<std::string(const mesh::TriangleMesh&)> write;
};

std::vector<Format> formats() {
    return {{"off", [](const auto& mesh) { return mesh::to_off(mesh); }},
            {"stl", [](const auto& mesh) { return mesh::to_stl(mesh); }},
            {"stl",
             [](const auto& mesh) {
                 return mesh::to_stl(mesh, std::vector<std::uint32_t>(mesh.triangles.size(), 0));
             }},
            {"obj", [](const auto& mesh) { return mesh::to_obj(mesh); }},
            {"ply", [](const auto& mesh) { return mesh::to_ply(mesh); }}};
}

std::string outcome_of(const std::string& bytes, const mesh::ReadMeshOptions& options,
                       const std::stop_token& stop = {}) {
    const auto read = mesh::read_mesh(bytes, "model", options, stop);
    return read ? "ok" : std::string(to_string(read.error().code));
}

TEST(ReadFormats, StopWhenTheyAreAskedTo) {
    std::stop_source source;
    source.request_stop();
    for (const Format& format : formats()) {
        const std::string bytes = format.write(sphere_mesh(5));
        EXPECT_EQ(outcome_of(bytes, {}), "ok") << format.name;
        EXPECT_EQ(outcome_of(bytes, {}, source.get_token()), "cancelled") << format.name;
    }
}

TEST(ReadFormats, HoldEachCapExactly) {
    const mesh::TriangleMesh cube = cube_mesh();
    const auto vertices = static_cast<std::uint32_t>(cube.vertices.size());
    const auto triangles = static_cast<std::uint32_t>(cube.triangles.size());
    for (const Format& format : formats()) {
        SCOPED_TRACE(format.name);
        const std::string bytes = format.write(cube);
        mesh::ReadMeshOptions options;
        options.max_bytes = bytes.size();
        options.max_vertices = vertices;
        options.max_faces = triangles;
        options.max_triangles = triangles;
        options.max_face_corners = 3;
        EXPECT_EQ(outcome_of(bytes, options), "ok");
        options.max_bytes = bytes.size() - 1;
        EXPECT_EQ(outcome_of(bytes, options), "file_too_large");
        options.max_bytes = bytes.size();
        options.max_vertices = vertices - 1;
        EXPECT_EQ(outcome_of(bytes, options), format.name + "_too_many_vertices");
        options.max_vertices = vertices;
        options.max_faces = triangles - 1;
        EXPECT_EQ(outcome_of(bytes, options), format.name + "_too_many_faces");
        options.max_faces = triangles;
        options.max_triangles = triangles - 1;
        EXPECT_EQ(outcome_of(bytes, options), format.name + "_too_many_faces");
        options.max_triangles = triangles;
        options.max_coordinate = cube.vertices[0].cwiseAbs().maxCoeff() / 2;
        EXPECT_NE(outcome_of(bytes, options), "ok");
    }
}

TEST(ReadFormats, DoNotAllocateWhatCountsPromiseWhenCapsAreRaised) {
    mesh::ReadMeshOptions options;
    options.max_vertices = 4'294'967'295u;
    options.max_faces = 4'294'967'295u;
    const std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\nproperty float x\n"
        "property float y\nproperty float z\nelement face 4294967295\n"
        "property list uchar int vertex_indices\nend_header\n";
    EXPECT_EQ(outcome_of(ply + std::string(1000, '\0'), options), "ply_truncated");
    std::string text = ply;
    text.replace(text.find("binary_little_endian"), 20, "ascii");
    EXPECT_EQ(outcome_of(text + "0 0 0\n", options), "ply_truncated");
    std::string stl = mesh::to_stl(cube_mesh());
    stl.replace(80, 4, std::string("\xff\xff\xff\x00", 4));
    EXPECT_EQ(outcome_of(stl, options), "stl_truncated");
}

TEST(ReadStl, NumbersVerticesInTheOrderOfTheirFirstUse) {
    const mesh::TriangleMesh cube = cube_mesh();
    const auto read = mesh::read_stl(mesh::to_stl(cube), "cube");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices.size(), 8u);
    std::uint32_t next = 0;
    for (const auto& triangle : read->mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            ASSERT_LE(vertex, next);
            if (vertex == next) ++next;
        }
    }
}

TEST(ReadObj, GoesThroughAFileOnceWhateverItsLinesEndWith) {
    // 300,000 lines that end with a lone CR before the only LF: looked for anew from each of them,
    // that would be found after 10^11 bytes.
    std::string text;
    const std::size_t vertices = 300'000;
    for (std::size_t v = 0; v < vertices; ++v) text += "v 0 " + std::to_string(v) + " 1\r";
    text += "f 1 2 3\n";
    const auto read = mesh::read_obj(text, "lines");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices.size(), vertices);
    EXPECT_EQ(read->mesh.triangles.size(), 1u);
}

TEST(ReadPly, SaysWhichByteIsAtFault) {
    std::string ply = mesh::to_ply(cube_mesh());
    const auto read = mesh::read_ply(ply.substr(0, ply.size() - 1), "cube");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kPlyTruncated);
    EXPECT_NE(read.error().message.find("byte " + std::to_string(ply.size() - 12)),
              std::string::npos)
        << read.error().message;
}

}  // namespace
}  // namespace ossuary::test
