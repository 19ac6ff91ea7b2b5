#include "index/model_files.h"

#include <gtest/gtest.h>

#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

class ModelFiles : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(root_ / "b" / "deep");
        for (const char* name : {"b/2.off", "b/10.OFF", "b/deep/1.off", "b/notes.txt", "a.off"}) {
            test::write_file(root_ / name, name);
        }
    }
    std::vector<std::string> found(const std::vector<fs::path>& paths) {
        const auto files = find_model_files(paths);
        EXPECT_TRUE(files);
        std::vector<std::string> names;
        for (const fs::path& file : *files) names.push_back(file.lexically_relative(root_));
        return names;
    }

    test::TemporaryFolder folder_;
    fs::path root_ = folder_.path() / "models";
};

TEST_F(ModelFiles, AreFoundBelowAFolderInTheOrderOfTheirBytes) {
    EXPECT_EQ(found({root_}),
              (std::vector<std::string>{"a.off", "b/10.OFF", "b/2.off", "b/deep/1.off"}));
    EXPECT_EQ(found({root_ / "b" / ""}),
              (std::vector<std::string>{"b/10.OFF", "b/2.off", "b/deep/1.off"}));
}

TEST_F(ModelFiles, AreTakenOnceHoweverOftenNamed) {
    EXPECT_EQ(found({root_, root_ / "a.off", root_ / "b" / ".." / "a.off"}), found({root_}));
}

TEST_F(ModelFiles, AreTakenWhateverTheirNameWhenNamed) {
    EXPECT_EQ(found({root_ / "b" / "notes.txt"}), (std::vector<std::string>{"b/notes.txt"}));
}

TEST_F(ModelFiles, MustExistWhenNamed) {
    const auto files = find_model_files({root_, root_ / "none"});
    ASSERT_FALSE(files);
    EXPECT_EQ(files.error().code, ErrorCode::kFileNotFound);
}

TEST_F(ModelFiles, AreNotFoundThroughLinksToFolders) {
    fs::create_directory_symlink(root_, root_ / "b" / "loop");
    EXPECT_EQ(found({root_}).size(), 4U);
}

TEST_F(ModelFiles, LieUnderTheirFoldersOnly) {
    EXPECT_TRUE(is_under("/m/a/x.off", {"/m/a"}));
    EXPECT_TRUE(is_under("/m/a", {"/m/a"}));
    EXPECT_FALSE(is_under("/m/ab/x.off", {"/m/a"}));
    EXPECT_FALSE(is_under("/m", {"/m/a"}));
    EXPECT_TRUE(is_under("/x", {"/m", "/"}));
}

TEST_F(ModelFiles, HavePathsOfOneForm) {
    EXPECT_EQ(index_path("/m/./a/../b/"), fs::path("/m/b"));
    EXPECT_EQ(index_path("/"), fs::path("/"));
    EXPECT_TRUE(index_path("x.off").is_absolute());
}

TEST_F(ModelFiles, GetTheirClassesByTheFirstNameThatIsThere) {
    const auto classification =
        ranking::parse_classification("PSB 1\n2 3\n\nant 0 2\n2\n10\n\nbee 0 1\n77\n", "x.cla");
    ASSERT_TRUE(classification);
    const auto classes =
        classes_by_file_name(*classification, {"/m/2.off", "/m/m2.off", "/m/m10.off"});
    EXPECT_EQ(classes, (std::map<std::string, std::string>{{"2.off", "ant"}, {"m10.off", "ant"}}));
}

TEST_F(ModelFiles, AreReadWholeAndNoFurtherThanAllowed) {
    EXPECT_EQ(*read_bytes(root_ / "a.off", 5), "a.off");
    EXPECT_EQ(read_bytes(root_ / "a.off", 4).error().code, ErrorCode::kFileTooLarge);
    EXPECT_EQ(read_bytes(root_ / "none", 4).error().code, ErrorCode::kFileNotFound);
    EXPECT_EQ(read_bytes(root_, 4).error().code, ErrorCode::kFileUnreadable);
}

}  // namespace
}  // namespace ossuary::index
