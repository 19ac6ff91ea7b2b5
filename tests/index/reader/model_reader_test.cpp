#include "index/model_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "engine/core/whole_file.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/write_mesh.h"
#include "tests/support/shapes.h"
#include "tests/support/source_folder.h"
#include "tests/support/temporary_folder.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

fs::path corpus(const char* file) { return test::source_folder() / "tests" / "corpus" / file; }

/// A glTF document of one triangle whose numbers are in a file of its own.
std::string triangle_beside(const std::string& uri) {
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
           R"("buffers":[{"byteLength":36,"uri":")" +
           uri + "\"}]}";
}

std::string triangle_numbers() {
    const float numbers[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    return {reinterpret_cast<const char*>(numbers), sizeof(numbers)};
}

void write(const fs::path& path, std::string_view bytes) {
    ASSERT_TRUE(write_whole_file(path, bytes));
}

class ModelReaderFiles : public testing::Test {
protected:
    test::TemporaryFolder temporary_;
    fs::path folder_ = temporary_.path() / "models";
    ModelReader reader_;

    void SetUp() override {
        fs::create_directories(folder_ / "below");
        write(temporary_.path() / "outside.bin", triangle_numbers());
        write(folder_ / "beside one.bin", triangle_numbers());
        write(folder_ / "below" / "numbers.bin", triangle_numbers());
        fs::create_symlink(temporary_.path() / "outside.bin", folder_ / "link.bin");
        fs::create_symlink("beside one.bin", folder_ / "inner_link.bin");
    }

    Result<mesh::ReadMeshResult> read_with(const std::string& uri) {
        write(folder_ / "model.gltf", triangle_beside(uri));
        return reader_.read(folder_ / "model.gltf");
    }
};

TEST_F(ModelReaderFiles, TakesBuffersBesideAndBelowTheFile) {
    for (const char* uri : {"beside%20one.bin", "below/numbers.bin", "./below/../below/numbers.bin",
                            "inner_link.bin"}) {
        const auto read = read_with(uri);
        ASSERT_TRUE(read) << uri << ": " << read.error().message;
        EXPECT_EQ(read->mesh.triangles.size(), 1u) << uri;
    }
}

TEST_F(ModelReaderFiles, TakesNoFileFromOutsideTheFolder) {
    for (const std::string& uri :
         {std::string("../outside.bin"), std::string("below/../../outside.bin"),
          std::string("link.bin"), (temporary_.path() / "outside.bin").string(),
          "file://" + (temporary_.path() / "outside.bin").string(), std::string("missing.bin"),
          std::string("below"), std::string("%2e%2e/outside.bin"), std::string("/dev/zero")}) {
        const auto read = read_with(uri);
        ASSERT_FALSE(read) << uri;
        EXPECT_EQ(read.error().code, ErrorCode::kGltfBuffer) << uri << read.error().message;
    }
    // The same process goes on.
    EXPECT_TRUE(read_with("below/numbers.bin"));
}

TEST_F(ModelReaderFiles, GivesAnUploadNoFile) {
    const std::string document = triangle_beside("below/numbers.bin");
    const auto read = reader_.read({document, "upload", {}});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kGltfBuffer);
}

TEST_F(ModelReaderFiles, HoldsAllFilesOfAModelAgainstTheLimitTogether) {
    write(folder_ / "model.gltf", triangle_beside("below/numbers.bin"));
    mesh::ReadMeshOptions caps;
    caps.max_bytes = fs::file_size(folder_ / "model.gltf");
    EXPECT_TRUE(reader_.read(folder_ / "model.gltf", {.mesh = caps}));
    write(folder_ / "below" / "numbers.bin", std::string(2000, '\0'));
    const auto read = reader_.read(folder_ / "model.gltf", {.mesh = caps});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kGltfBuffer);
}

TEST(ModelReader, ReadsTheFormatsOfTheProgramItself) {
    ModelReader reader({.limits = {}, .program = "/nowhere/ossuary-read"});
    const std::string off = mesh::to_off(test::torus_mesh(1.0, 0.3));
    EXPECT_TRUE(reader.read({off, "torus", {}}));
    const auto read = reader.read(ModelReader::Source{"nothing", "name", {}});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kFormatUnknown);
}

TEST(ModelReader, SaysWhereItsProgramWasExpected) {
    ModelReader reader({.limits = {}, .program = "/nowhere/ossuary-read"});
    const auto read = reader.read(corpus("3mf/ok/one_item.3mf"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kReaderUnavailable);
    EXPECT_NE(read.error().message.find("/nowhere/ossuary-read"), std::string::npos);
    ModelReader other({.limits = {}, .program = "/bin/true"});
    EXPECT_EQ(other.read(corpus("3mf/ok/one_item.3mf")).error().code,
              ErrorCode::kReaderUnavailable);
}

TEST(ModelReader, KeepsUnitAxisAndNames) {
    ModelReader reader;
    const auto inches = reader.read(corpus("3mf/ok/in_inches.3mf"));
    ASSERT_TRUE(inches);
    EXPECT_EQ(inches->metres_per_unit, 0.0254);
    EXPECT_EQ(inches->up, mesh::UpAxis::kZ);
    ASSERT_EQ(inches->objects.size(), 1u);
    EXPECT_EQ(inches->objects[0].name, "tetra");
    const auto instances = reader.read(corpus("gltf/ok/two_instances.gltf"));
    ASSERT_TRUE(instances);
    EXPECT_EQ(instances->metres_per_unit, 1.0);
    EXPECT_EQ(instances->up, mesh::UpAxis::kY);
    ASSERT_EQ(instances->objects.size(), 2u);
    EXPECT_EQ(instances->objects[0].name, "left");
    EXPECT_EQ(instances->objects[1].name, "right");
    EXPECT_EQ(instances->objects[1].first_triangle, 4u);
    EXPECT_EQ(instances->objects[1].triangles, 4u);
    EXPECT_EQ(instances->mesh.vertices[4].x(), 3.0);
}

/// The volume that a closed surface holds, negative where it is inside out.
double signed_volume(const mesh::TriangleMesh& mesh) {
    double volume = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.corners(t);
        volume += a.dot(b.cross(c)) / 6.0;
    }
    return volume;
}

TEST(ModelReader, TurnsNothingInsideOut) {
    ModelReader reader;
    for (const char* file :
         {"gltf/ok/indexed_tetrahedron.gltf", "gltf/ok/mirrored_node.gltf", "gltf/ok/draco.gltf",
          "gltf/ok/meshopt.gltf", "3mf/ok/one_item.3mf", "3mf/ok/item_mirrored.3mf"}) {
        const auto read = reader.read(corpus(file));
        ASSERT_TRUE(read) << file << read.error().message;
        EXPECT_NEAR(signed_volume(read->mesh), 1.0 / 6.0, 1e-6) << file;
    }
    const auto strip = reader.read(corpus("gltf/ok/strip.gltf"));
    const auto fan = reader.read(corpus("gltf/ok/fan.gltf"));
    for (const auto* read : {&strip, &fan}) {
        ASSERT_TRUE(*read);
        for (std::size_t t = 0; t < (**read).mesh.triangles.size(); ++t) {
            const auto [a, b, c] = (**read).mesh.corners(t);
            EXPECT_GT((b - a).cross(c - a).z(), 0.0) << t;
        }
    }
}

TEST(ModelReader, ServesManyThreadsAtOnce) {
    ModelReader reader;
    std::vector<std::jthread> threads;
    std::atomic<int> right = 0;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&, i] {
            for (int round = 0; round < 20; ++round) {
                const auto read = reader.read(
                    corpus(i % 2 == 0 ? "3mf/ok/two_items_moved.3mf" : "gltf/ok/strip.gltf"));
                if (read && read->mesh.triangles.size() == (i % 2 == 0 ? 8u : 3u)) ++right;
            }
        });
    }
    threads.clear();
    EXPECT_EQ(right, 160);
}

}  // namespace
}  // namespace ossuary::index
