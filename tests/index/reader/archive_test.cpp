// Models in ZIP archives.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/mesh/write_mesh.h"
#include "index/model_place.h"
#include "index/model_reader.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class Archives : public testing::Test {
protected:
    using Members = std::vector<std::pair<std::string, std::string>>;

    fs::path write(const char* name, const Members& members) {
        return test::write_zip(folder_.path() / name, members);
    }
    /// The number of triangles of what is read, or the code of why not.
    std::string read(const fs::path& path, const mesh::ReadMeshOptions& caps = {}) {
        const auto result = reader_.read(path, {.mesh = caps});
        if (result) return std::to_string(result->mesh.triangles.size());
        message_ = result.error().message;
        EXPECT_TRUE(message_.starts_with(path.string())) << message_;
        return std::string(to_string(result.error().code));
    }

    test::TemporaryFolder folder_;
    ModelReader reader_;
    const std::string box_ = mesh::to_off(test::box_mesh({0, 0, 0}, {1, 2, 3}));
    const std::string ring_ = mesh::to_stl(test::torus_mesh(1.0, 0.3));
    const std::string ring_triangles_ = std::to_string(test::torus_mesh(1.0, 0.3).triangles.size());
    std::string message_;
};

TEST_F(Archives, OfOneModelAreThatModel) {
    const fs::path path = write("one.zip", {{"readme.txt", "a ring"},
                                            {"parts/ring.STL", ring_},
                                            {"__MACOSX/parts/._ring.stl", "no mesh"},
                                            {"parts/.hidden.off", box_}});
    EXPECT_EQ(read(path), ring_triangles_);
    EXPECT_EQ(read(path.string() + "#parts/ring.STL"), ring_triangles_);
    EXPECT_EQ(read(path.string() + "#parts/.hidden.off"), "12");
    const auto opened = reader_.open(path, 1 << 20);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->bytes.view(), ring_);
    EXPECT_EQ(opened->name, path.string() + "#parts/ring.STL");
    // Whatever they are called, and from memory.
    fs::rename(path, folder_.path() / "ring.stl");
    EXPECT_EQ(read(folder_.path() / "ring.stl"), ring_triangles_);
    const auto bytes = read_whole_file(folder_.path() / "ring.stl");
    ASSERT_TRUE(bytes);
    const auto from_memory = reader_.read({bytes->view(), "upload"});
    ASSERT_TRUE(from_memory) << from_memory.error().message;
    EXPECT_EQ(std::to_string(from_memory->mesh.triangles.size()), ring_triangles_);
}

TEST_F(Archives, OfSeveralModelsAreAskedForOne) {
    const fs::path path = write("two.zip", {{"a/box.off", box_}, {"ring.stl", ring_}});
    EXPECT_EQ(read(path), "archive_several");
    EXPECT_THAT(message_, HasSubstr("2; name one after '#': 'a/box.off', 'ring.stl'"));
    EXPECT_EQ(read(path.string() + "#a/box.off"), "12");
    EXPECT_EQ(read(path.string() + "#ring.stl"), ring_triangles_);
    EXPECT_EQ(read(path.string() + "#a/Box.off"), "archive_member");
    EXPECT_EQ(read(path.string() + "#../ring.stl"), "archive_member");
    const auto listed = reader_.list_archive(path);
    ASSERT_TRUE(listed) << listed.error().message;
    EXPECT_THAT(listed->names, ElementsAre("a/box.off", "ring.stl"));
    EXPECT_FALSE(listed->is_package);
}

TEST_F(Archives, AreRefusedWithACode) {
    EXPECT_EQ(read(write("none.zip", {{"readme.txt", "nothing"}})), "archive_empty");
    EXPECT_EQ(read(write("deep.zip", {{"one.zip", "x"}})), "archive_empty");
    const fs::path inner = write("inner.zip", {{"box.off", box_}});
    const std::string packed(read_whole_file(inner)->view());
    EXPECT_EQ(read(write("disguised.zip", {{"box.off", packed}})), "format_unsupported");
    EXPECT_EQ(read(write("text.zip", {{"box.off", "no mesh"}})), "format_unknown");
    mesh::ReadMeshOptions little;
    little.max_bytes = 1000;
    EXPECT_EQ(read(write("large.zip", {{"zeros.stl", std::string(1001, '\0')}}), little),
              "file_too_large");
    EXPECT_EQ(read(folder_.path() / "gone.zip#box.off"), "file_not_found");
    EXPECT_EQ(message_,
              (folder_.path() / "gone.zip#box.off").string() + ": No such file or directory");
}

TEST_F(Archives, ThatAreDamagedAreRefusedWithACode) {
    const fs::path path = write("two.zip", {{"box.off", box_}, {"ring.stl", ring_}});
    const std::string whole(read_whole_file(path)->view());
    for (std::size_t size = 4; size < whole.size(); size += 97) {
        const auto cut = reader_.read({std::string_view(whole).substr(0, size), "cut"});
        ASSERT_FALSE(cut) << size;
        ASSERT_EQ(to_string(cut.error().code), "archive_invalid") << cut.error().message;
    }
    for (std::size_t at = 0; at < whole.size(); at += 31) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
        ASSERT_TRUE(write_whole_file(path, damaged));
        for (const char* member : {"#box.off", "#ring.stl"}) {
            const auto read = reader_.read(path.string() + member);
            if (read) continue;
            const ErrorCode code = read.error().code;
            ASSERT_TRUE(code == ErrorCode::kArchiveInvalid || code == ErrorCode::kArchiveMember)
                << at << ": " << read.error().message;
        }
    }
}

TEST_F(Archives, HoldTheFilesThatTheirModelsReferTo) {
    const std::string gltf = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"uri": "data/shape.bin", "byteLength": 36}]})";
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string buffer(reinterpret_cast<const char*>(corners), sizeof(corners));
    EXPECT_EQ(read(write("scene.zip", {{"scene/a.gltf", gltf}, {"scene/data/shape.bin", buffer}})),
              "1");
    const fs::path without = write("without.zip", {{"a.gltf", gltf}, {"shape.bin", buffer}});
    const auto result = reader_.read(without);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kGltfBuffer);
    EXPECT_THAT(result.error().message, HasSubstr("'data/shape.bin'"));
}

TEST_F(Archives, OfOtherFormatsAreThose) {
    const auto mesh = test::box_mesh({0, 0, 0}, {1, 2, 3});
    const fs::path package = test::write_three_mf(
        folder_.path() / "box.zip",
        test::three_mf_part(test::three_mf_object(mesh), "<item objectid=\"1\"/>"));
    EXPECT_EQ(read(package), "12");
    EXPECT_TRUE(reader_.list_archive(package)->is_package);
    const std::string bytes(read_whole_file(package)->view());
    EXPECT_EQ(read(write("packed.zip", {{"box.3mf", bytes}})), "12");
}

TEST_F(Archives, AreToldFromFilesWithSuchNames) {
    const fs::path file = folder_.path() / "a.zip#b.off";
    EXPECT_EQ(place_of(file).member, "b.off");
    EXPECT_EQ(place_of(file).file, folder_.path() / "a.zip");
    EXPECT_EQ(place_of(file).file_name(), "b.off");
    EXPECT_EQ(place_of(file).name(), "b");
    ASSERT_TRUE(write_whole_file(file, box_));
    EXPECT_EQ(place_of(file).member, "");
    EXPECT_EQ(place_of(file).file_name(), "a.zip#b.off");
    EXPECT_EQ(read(file), "12");
    EXPECT_EQ(place_of("notes#1/b.off").member + place_of("notes#1/b.off").object, "");
    EXPECT_EQ(place_of("a.zip#").file, "a.zip#");
    EXPECT_EQ(place_of("a.zip#folder/part.stl").file_name(), "part.stl");
}

TEST(ModelPlaces, AreParted) {
    const auto expect = [](const char* path, const char* file, const char* member,
                           const char* object, const char* name) {
        const ModelPlace place = place_of(path);
        EXPECT_EQ(place.file, file);
        EXPECT_EQ(place.member, member);
        EXPECT_EQ(place.object, object);
        EXPECT_EQ(place.name(), name);
        EXPECT_EQ(path_of(place), path);
    };
    expect("plate.3mf#Wheel", "plate.3mf", "", "Wheel", "Wheel");
    expect("x#1/plate.3mf#left/Wheel #2", "x#1/plate.3mf", "", "left/Wheel #2", "left/Wheel #2");
    expect("toys.ZIP#car.glb", "toys.ZIP", "car.glb", "", "car");
    expect("toys.zip#a/car.glb#Wheel", "toys.zip", "a/car.glb", "Wheel", "Wheel");
}

}  // namespace
}  // namespace ossuary::index
