#include "engine/mesh/read_mesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/mesh/inspect.h"
#include "engine/mesh/write_mesh.h"
#include "tests/engine/mesh/built_meshes.h"
#include "tests/support/benchmark_data.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

class ReadMesh : public testing::Test {
protected:
    ReadMesh() : folder_(fs::path(testing::TempDir()) / ("read_mesh_" + name())) {
        fs::create_directories(folder_);
    }
    ~ReadMesh() override { fs::remove_all(folder_); }
    static std::string name() {
        return testing::UnitTest::GetInstance()->current_test_info()->name();
    }

    fs::path folder_;
};

TEST_F(ReadMesh, ReadsAFileAsItsBytes) {
    const mesh::TriangleMesh sphere = sphere_mesh(2);
    ASSERT_TRUE(mesh::write_off(sphere, folder_ / "sphere.off"));
    const auto read = mesh::read_mesh(folder_ / "sphere.off");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices, sphere.vertices);
    EXPECT_EQ(read->mesh.triangles, sphere.triangles);
    EXPECT_TRUE(read->warnings.empty());
}

TEST_F(ReadMesh, FollowsTheContentsNotTheName) {
    ASSERT_TRUE(mesh::write_off(cube_mesh(), folder_ / "cube.stl"));
    EXPECT_TRUE(mesh::read_mesh(folder_ / "cube.stl"));
    ASSERT_TRUE(mesh::write_obj(cube_mesh(), folder_ / "cube.off"));
    EXPECT_TRUE(mesh::read_mesh(folder_ / "cube.off"));
    std::ofstream(folder_ / "cube.obj") << "ISO-10303-21;\nHEADER;\n";
    const auto read = mesh::read_mesh(folder_ / "cube.obj");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kFormatUnsupported);
    EXPECT_NE(read.error().message.find("STEP"), std::string::npos) << read.error().message;
}

TEST_F(ReadMesh, TellsMissingFromUnreadable) {
    EXPECT_EQ(mesh::read_mesh(folder_ / "nothing.off").error().code, ErrorCode::kFileNotFound);
    EXPECT_EQ(mesh::read_mesh(folder_).error().code, ErrorCode::kFileUnreadable);
    EXPECT_EQ(mesh::read_mesh(fs::path("/dev/zero")).error().code, ErrorCode::kFileUnreadable);
}

TEST_F(ReadMesh, RefusesFilesOverTheCapBeforeReadingThem) {
    ASSERT_TRUE(mesh::write_off(cube_mesh(), folder_ / "cube.off"));
    mesh::ReadMeshOptions options;
    options.max_bytes = fs::file_size(folder_ / "cube.off");
    EXPECT_TRUE(mesh::read_mesh(folder_ / "cube.off", options));
    --options.max_bytes;
    EXPECT_EQ(mesh::read_mesh(folder_ / "cube.off", options).error().code,
              ErrorCode::kFileTooLarge);
    // A sparse file of a terabyte.
    std::ofstream(folder_ / "huge.off") << "OFF";
    fs::resize_file(folder_ / "huge.off", std::uintmax_t{1} << 40);
    EXPECT_EQ(mesh::read_mesh(folder_ / "huge.off").error().code, ErrorCode::kFileTooLarge);
    EXPECT_EQ(mesh::read_mesh(mesh::to_off(cube_mesh()), "cube", options).error().code,
              ErrorCode::kFileTooLarge);
}

TEST_F(ReadMesh, RefusesSixtyMegabytesOfNonsenseQuickly) {
    const std::string nonsense(60'000'000, 'A');
    EXPECT_EQ(mesh::read_mesh(nonsense, "upload").error().code, ErrorCode::kFormatUnknown);
    EXPECT_LT(mesh::read_mesh(nonsense, "upload").error().message.size(), 200u);
    EXPECT_EQ(mesh::read_mesh("OFF" + nonsense, "upload").error().code, ErrorCode::kOffHeader);
    EXPECT_EQ(mesh::read_mesh("OFF\n9 9 9\n" + nonsense, "upload").error().code,
              ErrorCode::kOffBadNumber);
    EXPECT_LT(mesh::read_mesh("OFF\n9 9 9\n" + nonsense, "upload").error().message.size(), 200u);
}

TEST_F(ReadMesh, PicksModelFilesByExtensionInAnyCase) {
    for (const char* name :
         {"a.off", "A.OFF", "b.Off", "c.coff", "d.NOFF", "e.stoff", ".x.off", "f.stl", "F.STL",
          "g.obj", "h.ply", "a.off.gz", "B.Nii.GZ", "c.nrrd"}) {
        EXPECT_TRUE(mesh::is_model_file(name)) << name;
    }
    for (const char* name :
         {"a.blend", "off", ".off", "a.tar.gz", "a.gz", "a.offx", "a.expect", "a", ""}) {
        EXPECT_FALSE(mesh::is_model_file(name)) << name;
    }
}

TEST_F(ReadMesh, ReadsSomeOfEachBenchmarkCollection) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    std::size_t read_files = 0;
    for (const char* collection : {"princeton-segmentation", "princeton-shape-train"}) {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(data / collection / "off")) {
            files.push_back(entry.path());
        }
        std::sort(files.begin(), files.end());
        for (std::size_t i = 0; i < files.size(); i += 25) {
            const auto read = mesh::read_mesh(files[i]);
            ASSERT_TRUE(read) << read.error().message;
            EXPECT_FALSE(read->mesh.empty()) << files[i];
            ++read_files;
            const mesh::MeshReport report = mesh::inspect(read->mesh);
            if (std::string(collection) == "princeton-segmentation") {
                EXPECT_TRUE(report.closed && report.edge_manifold) << files[i];
            }
        }
    }
    EXPECT_GE(read_files, 16u);
}

}  // namespace
}  // namespace ossuary::test
