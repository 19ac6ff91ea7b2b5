#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/whole_file.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "tests/index/cli/run_program.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

// Files that the reader process reads, through every command that takes a model.
namespace ossuary::test {
namespace {

using ::testing::HasSubstr;

class ForeignFiles : public ::testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directory(models());
        const mesh::TriangleMesh tree = capsule_tree_mesh();
        ASSERT_TRUE(mesh::write_off(tree, models() / "tree.off"));
        ASSERT_TRUE(write_whole_file(models() / "tree.glb", to_plain_glb(tree)));
        write_three_mf(models() / "tree.3mf",
                       three_mf_part(three_mf_object(tree), "<item objectid=\"1\"/>"));
        ASSERT_TRUE(write_whole_file(models() / "ring.glb", to_plain_glb(torus_mesh(2.0, 0.5))));
    }

    [[nodiscard]] std::filesystem::path models() const { return folder_.path() / "models"; }
    [[nodiscard]] std::string index_file() const { return folder_.path() / "some.ossuary"; }
    ProgramResult run(std::vector<std::string> arguments) {
        return run_ossuary(arguments, folder_.path());
    }

    TemporaryFolder folder_;
};

TEST_F(ForeignFiles, AreIndexedFoundComparedCutAndReduced) {
    const ProgramResult built =
        run({"index", "--index", index_file(), "--resolution", "24", "--json", models()});
    ASSERT_EQ(built.exit_status, 0) << built.err;
    EXPECT_EQ(built.json().at("indexed"), 4);
    for (const char* file : {"tree.glb", "tree.3mf"}) {
        const ProgramResult found =
            run({"search", "--index", index_file(), models() / file, "--limit", "4", "--json"});
        ASSERT_EQ(found.exit_status, 0) << found.err;
        for (std::size_t hit = 0; hit < 3; ++hit) {
            EXPECT_EQ(found.json().at("hits")[hit].at("name"), "tree") << file;
            EXPECT_LE(found.json().at("hits")[hit].at("distance").get<double>(), 0.02) << file;
        }
        const ProgramResult compared =
            run({"compare", models() / "tree.off", models() / file, "--json"});
        ASSERT_EQ(compared.exit_status, 0) << compared.err;
        EXPECT_LE(compared.json().at("distance").get<double>(), 0.02) << file;
        EXPECT_EQ(run({"skeleton", models() / file, "--json"}).exit_status, 0);
        const ProgramResult cut =
            run({"segment", models() / file, "--out", folder_.path() / "parts.seg", "--json"});
        EXPECT_EQ(cut.exit_status, 0) << cut.err;
    }
}

TEST_F(ForeignFiles, ThatCannotBeReadAreFailuresOfTheirOwn) {
    ASSERT_TRUE(
        write_whole_file(models() / "cut.glb", to_plain_glb(torus_mesh(2.0, 0.5)).substr(0, 900)));
    std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
    deep += std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}";
    ASSERT_TRUE(write_whole_file(models() / "deep.gltf", deep));
    const ProgramResult built =
        run({"index", "--index", index_file(), "--resolution", "24", "--json", models()});
    EXPECT_EQ(built.exit_status, 3) << built.err;
    EXPECT_EQ(built.json().at("indexed"), 4);
    EXPECT_EQ(built.json().at("failed"), 2);
    EXPECT_THAT(built.err, HasSubstr("gltf_invalid"));
    EXPECT_THAT(built.err, HasSubstr("reader_crashed"));
    const ProgramResult again =
        run({"index", "--index", index_file(), "--resolution", "24", "--json", models()});
    EXPECT_EQ(again.json().at("unchanged"), 4);
    EXPECT_EQ(again.json().at("known_failures"), 2);
}

}  // namespace
}  // namespace ossuary::test
