#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/index/cli/run_program.h"
#include "tests/index/sample_index.h"

// What `index` makes of folders as they are: hidden files, links, disks that are not there.
namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;
using ::testing::Not;

class Walking : public ::testing::Test {
protected:
    void SetUp() override { write_sample_meshes(models(), 4); }

    [[nodiscard]] fs::path models() const { return folder_.path() / "models"; }
    [[nodiscard]] std::string index_file() const { return folder_.path() / "some.ossuary"; }
    ProgramResult index(std::vector<std::string> more, int expected_status) {
        more.insert(more.begin(), {"index", "--index", index_file(), "--resolution", "24"});
        ProgramResult result = run_ossuary(more, folder_.path());
        EXPECT_EQ(result.exit_status, expected_status) << result.err;
        return result;
    }
    int count() {
        return run_ossuary({"models", "--index", index_file(), "--json"}, folder_.path())
            .json()
            .at("total")
            .get<int>();
    }

    TemporaryFolder folder_;
};

TEST_F(Walking, PassesOverHiddenFilesAndSaysSoOnce) {
    write_file(models() / "._00_box.off", "Mac OS X resource fork");
    fs::create_directory(models() / ".Trashes");
    fs::create_directory_symlink("nowhere", models() / "gone");
    write_file(models() / "readme.txt", "x");
    for (int run = 0; run < 2; ++run) {
        const ProgramResult result = index({models()}, 0);
        EXPECT_THAT(result.err,
                    HasSubstr("passed over: hidden 2, links that lead nowhere 1, files that are no "
                              "models 1\n"));
    }
    const nlohmann::json counts = index({"--json", models()}, 0).json().at("passed_over");
    EXPECT_EQ(counts, (nlohmann::json{{"hidden", 2},
                                      {"excluded", 0},
                                      {"seen_before", 0},
                                      {"broken_links", 1},
                                      {"special", 0},
                                      {"other_files", 1}}));
    EXPECT_THAT(index({models() / "._00_box.off"}, 3).err, HasSubstr("format_unknown"))
        << "named, it is tried";
}

TEST_F(Walking, SaysNothingWhereNothingIsPassedOver) {
    EXPECT_THAT(index({models()}, 0).err, Not(HasSubstr("passed over")));
}

TEST_F(Walking, LeavesOutPatternsAndPrunesThemWhenAsked) {
    fs::create_directory(models() / "old");
    fs::rename(models() / "00_box.off", models() / "old" / "00_box.off");
    EXPECT_EQ(index({models(), "--json"}, 0).json().at("indexed"), 4);
    EXPECT_EQ(
        index({models(), "--exclude", "old/**", "--exclude=03*", "--json"}, 0).json().at("files"),
        2);
    EXPECT_EQ(count(), 4);
    const nlohmann::json pruned =
        index({"--prune", models(), "--exclude", "old/**", "--json"}, 0).json();
    EXPECT_EQ(pruned.at("pruned"), 1);
    EXPECT_EQ(count(), 3);
    EXPECT_THAT(index({models(), "--exclude", "[a"}, 2).err, HasSubstr("invalid_argument"));
}

TEST_F(Walking, ReportsFoldersThatCannotBeReadAndGoesOn) {
    make_unreadable_folder(models());
    const ProgramResult result = index({models(), "--json"}, 3);
    EXPECT_EQ(result.json().at("indexed"), 4);
    ASSERT_EQ(result.json().at("unreadable").size(), 1);
    EXPECT_EQ(result.json().at("unreadable")[0].at("code"), "file_unreadable");
    EXPECT_THAT(result.err, HasSubstr("file_unreadable"));
}

TEST_F(Walking, DoesNotEmptyAnIndexForADiskThatIsNotMounted) {
    const fs::path other = folder_.path() / "other";
    write_sample_meshes(other, 2);
    index({models(), other}, 0);
    ASSERT_EQ(count(), 6);
    fs::rename(models(), folder_.path() / "unmounted");
    fs::remove(other / "00_box.off");
    // Other bytes than those of any file that is gone: those would be taken for moved.
    fs::copy_file(other / "01_tree.off", other / "02_new.off");
    std::ofstream(other / "02_new.off", std::ios::app) << "# another\n";
    for (const bool mount_point_is_there : {false, true}) {
        if (mount_point_is_there) fs::create_directory(models());
        const ProgramResult refused = index({"--prune", models(), other, "--json"}, 1);
        EXPECT_THAT(refused.err, HasSubstr("prune_refused"));
        const nlohmann::json outcome = refused.json();
        ASSERT_EQ(outcome.at("prune_refused").size(), 1);
        EXPECT_EQ(outcome.at("prune_refused")[0].at("path"), models().string());
        EXPECT_EQ(outcome.at("prune_refused")[0].at("models"), 4);
        EXPECT_EQ(outcome.at("pruned"), mount_point_is_there ? 0 : 1) << "the other's";
        EXPECT_EQ(outcome.at("indexed"), mount_point_is_there ? 0 : 1);
        EXPECT_EQ(count(), 6);
    }
    fs::remove(models());
    fs::rename(folder_.path() / "unmounted", models());
    EXPECT_EQ(index({"--prune", models(), other, "--json"}, 0).json().at("unchanged"), 6);
    fs::remove_all(models());
    EXPECT_EQ(index({"--prune=force", models(), other, "--json"}, 0).json().at("pruned"), 4);
    EXPECT_EQ(count(), 2);
}

TEST_F(Walking, TakesPruneAloneOrByForceAndNothingElse) {
    index({models()}, 0);
    index({"--prune", models()}, 0);
    index({"--prune=force", models()}, 0);
    EXPECT_THAT(index({"--prune=hard", models()}, 2).err, HasSubstr("hard"));
    // A path that was never there is a slip of the pen, whatever is to be pruned.
    EXPECT_THAT(index({"--prune", models(), models() / "none"}, 1).err,
                HasSubstr("file_not_found"));
    EXPECT_EQ(count(), 4);
}

}  // namespace
}  // namespace ossuary::test
