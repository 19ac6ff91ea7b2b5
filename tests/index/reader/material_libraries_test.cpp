// OBJ files and the material libraries beside them.

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/core/whole_file.h"
#include "engine/mesh/write_mesh.h"
#include "index/companion_hash.h"
#include "index/describe_model.h"
#include "index/model_reader.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

class MaterialLibraries : public testing::Test {
protected:
    /// Reads a box that is made of `paint` of this library, named in this way.
    Result<mesh::ReadMeshResult> read(const std::string& library) {
        return reader_.read(write("box.obj", obj(library)));
    }
    fs::path write(const std::string& name, const std::string& bytes) {
        const fs::path path = folder_.path() / name;
        fs::create_directories(path.parent_path());
        EXPECT_TRUE(write_whole_file(path, bytes));
        return path;
    }
    static std::string obj(const std::string& library) {
        return "mtllib " + library + "\nusemtl paint\n" +
               mesh::to_obj(test::box_mesh(Vec3::Zero(), Vec3::Ones()));
    }
    static bool is_coloured(const Result<mesh::ReadMeshResult>& read, const mesh::Colour& colour) {
        return read && read->mesh.corner_colours ==
                           std::vector<mesh::CornerColours>(read->mesh.triangles.size(),
                                                            {colour, colour, colour});
    }

    test::TemporaryFolder folder_;
    ModelReader reader_;
};

TEST_F(MaterialLibraries, ColourTheModelsBesideThem) {
    write("paints.mtl", "newmtl paint\nKd 1 0 0\n");
    write("more/my paints.mtl", "newmtl paint\nKd 0 0 1\n");
    for (const char* name : {"paints.mtl", "./paints.mtl", "gone.mtl paints.mtl"}) {
        EXPECT_TRUE(is_coloured(read(name), {255, 0, 0})) << name;
    }
    for (const char* name : {"more/my paints.mtl", "more\\my paints.mtl"}) {
        EXPECT_TRUE(is_coloured(read(name), {0, 0, 255})) << name;
    }
    EXPECT_TRUE(read("paints.mtl")->warnings.empty());
}

TEST_F(MaterialLibraries, AreWarnedOfWhereThereIsNoneOrTheyLieElsewhere) {
    write("elsewhere.mtl", "newmtl paint\nKd 1 0 0\n");
    fs::create_directories(folder_.path() / "models");
    for (const std::string name : {"gone.mtl", "../elsewhere.mtl"}) {
        const auto read = reader_.read(write("models/box.obj", obj(name)));
        ASSERT_TRUE(read);
        EXPECT_TRUE(read->mesh.corner_colours.empty());
        ASSERT_EQ(read->warnings.size(), 1u);
        EXPECT_EQ(read->warnings[0].code, "material_library_missing");
        EXPECT_NE(read->warnings[0].message.find(name), std::string::npos);
    }
    const auto alone = reader_.read(ModelReader::Source{obj("gone.mtl"), "box.obj"});
    ASSERT_TRUE(alone);
    EXPECT_TRUE(alone->warnings.empty());
}

TEST_F(MaterialLibraries, AreFoundInAnArchive) {
    const fs::path archive = test::write_zip(
        folder_.path() / "toy.zip",
        {{"a/box.obj", obj("paints.mtl")}, {"a/paints.mtl", "newmtl paint\nKd 1 0 0\n"}});
    EXPECT_TRUE(is_coloured(reader_.read(archive), {255, 0, 0}));
}

TEST_F(MaterialLibraries, ArePartOfWhatAModelsHashIsOf) {
    const std::string box = obj("paints.mtl");
    const auto companions = [&](std::string_view name, std::uint64_t most) {
        return open_beneath(folder_.path(), name, most);
    };
    const std::string without = hash_with_companions(box, companions);
    write("paints.mtl", "newmtl paint\nKd 1 0 0\n");
    const std::string red = hash_with_companions(box, companions);
    write("paints.mtl", "newmtl paint\nKd 0 0 1\n");
    EXPECT_NE(without, red);
    EXPECT_NE(hash_with_companions(box, companions), red);
    EXPECT_EQ(referred_files(box), std::vector<std::string>{"paints.mtl"});
    const std::string plain = mesh::to_obj(test::box_mesh(Vec3::Zero(), Vec3::Ones()));
    EXPECT_TRUE(referred_files(plain).empty());
    EXPECT_EQ(hash_with_companions(plain, companions), hash_with_companions(plain, {}));
}

}  // namespace
}  // namespace ossuary::index
