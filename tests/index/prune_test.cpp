#include "index/prune.h"

#include <gtest/gtest.h>
#include <limits.h>

#include <optional>

#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

/// Two folders of files and an index that had them all when the run began.
class PruneTest : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"a/1.off", "a/2.off", "a/3.off", "b/1.off", "b/sub/2.off"}) {
            add(name);
        }
    }
    fs::path path(const std::string& name) const { return folder_.path() / name; }
    void add(const std::string& name) {
        fs::create_directories(path(name).parent_path());
        test::write_file(path(name), name);
        ModelSummary model;
        model.id = static_cast<ModelId>(models_.size()) + 1;
        model.path = path(name);
        models_.push_back(model);
        before_.push_back(path(name));
    }
    PrunePlan plan(const std::vector<std::string>& roots, bool force = false,
                   std::optional<std::string_view> exclude = {}) {
        std::vector<fs::path> paths;
        for (const std::string& root : roots) paths.push_back(path(root));
        WalkOptions options;
        if (exclude) options.exclude.push_back(*Glob::parse(*exclude));
        const auto found = find_model_files(paths, options);
        EXPECT_TRUE(found);
        return plan_prune({before_, models_, failures_}, paths, *found, options, force);
    }

    test::TemporaryFolder folder_;
    std::vector<ModelSummary> models_;
    std::vector<std::string> before_;
    std::vector<Failure> failures_;
};

using Ids = std::vector<ModelId>;

TEST_F(PruneTest, TakesWhatIsGoneUnderTheRoots) {
    fs::remove(path("a/2.off"));
    fs::remove(path("b/1.off"));
    EXPECT_EQ(plan({"a"}).models, (Ids{2}));
    EXPECT_EQ(plan({"a", "b"}).models, (Ids{2, 4}));
    fs::remove(path("a/1.off"));  // 2 of 3 gone, but the folder is plainly there
    EXPECT_EQ(plan({"a"}).models, (Ids{1, 2}));
    EXPECT_TRUE(plan({"a"}).refusals.empty());
}

TEST_F(PruneTest, SparesARootThatIsEmptyOrGone) {
    for (const bool gone : {false, true}) {
        fs::remove_all(path("a"));
        if (!gone) {
            fs::create_directories(path("a/lost+found"));
            test::write_file(path("a/readme.txt"), "mount me");
        }
        fs::remove(path("b/1.off"));
        const PrunePlan refused = plan({"a", "b"});
        EXPECT_EQ(refused.models, (Ids{4})) << "the other root is pruned all the same";
        ASSERT_EQ(refused.refusals.size(), 1U);
        EXPECT_EQ(refused.refusals[0].place, path("a"));
        EXPECT_EQ(refused.refusals[0].models, 3U);
        EXPECT_EQ(refused.refusals[0].gone, 3U);
        EXPECT_EQ(plan({"a", "b"}, true).models, (Ids{1, 2, 3, 4}));
        EXPECT_TRUE(plan({"a", "b"}, true).refusals.empty());
    }
}

TEST_F(PruneTest, SparesFailuresOfSuchARootToo) {
    failures_ = {{path("a/bad.off"), "", "off_header", "", ""},
                 {path("b/bad.off"), "", "off_header", "", ""}};
    fs::remove_all(path("a"));
    EXPECT_EQ(plan({"a", "b"}).failures, (std::vector<std::string>{path("b/bad.off")}));
    EXPECT_EQ(plan({"a", "b"}, true).failures.size(), 2U);
}

TEST_F(PruneTest, TakesUpToHalfOfARootThatIsEmpty) {
    // The others have moved, and are in the index under their new paths.
    for (const char* name : {"a/1.off", "a/2.off"}) {
        fs::create_directories(path("c"));
        fs::rename(path(name), path("c") / fs::path(name).filename());
    }
    models_[0].path = path("c/1.off");
    models_[1].path = path("c/2.off");
    fs::remove(path("a/3.off"));
    EXPECT_EQ(plan({"a", "c"}).models, (Ids{3}));
}

TEST_F(PruneTest, SparesWhatALinkLedToThatLeadsNowhere) {
    fs::create_directories(path("disk"));
    fs::create_directory_symlink(path("disk"), path("b/link"));
    add("b/link/6.off");
    EXPECT_TRUE(plan({"b"}).models.empty());
    fs::remove_all(path("disk"));
    const PrunePlan refused = plan({"b"});
    EXPECT_TRUE(refused.models.empty());
    ASSERT_EQ(refused.refusals.size(), 1U);
    EXPECT_EQ(refused.refusals[0].place, path("b/link"));
    EXPECT_EQ(plan({"b"}, true).models, (Ids{6}));
}

TEST_F(PruneTest, TakesWhatIsPassedOver) {
    add("a/.trash/6.off");
    add("a/@eaDir/7.off");
    failures_ = {{path("a/._1.off"), "", "off_header", "", ""}};
    test::write_file(path("a/._1.off"), "x");
    EXPECT_EQ(plan({"a"}).models, (Ids{6, 7}));
    EXPECT_EQ(plan({"a"}).failures.size(), 1U);
    EXPECT_EQ(plan({"b"}, false, "sub/").models, (Ids{5}));
    EXPECT_EQ(plan({"a", "a/.trash"}).models, (Ids{7})) << "named, so not hidden";
}

TEST_F(PruneTest, TakesLinksToWhatIsTakenUnderItsOwnPath) {
    fs::create_symlink(path("a/1.off"), path("a/0.off"));
    add("a/link.off");
    fs::remove(path("a/link.off"));
    fs::create_symlink(path("a/2.off"), path("a/link.off"));
    EXPECT_EQ(plan({"a"}).models, (Ids{6}));
}

TEST_F(PruneTest, LeavesWhatCanOnlyBeIndexedByBeingNamed) {
    add("a/model.txt");
    EXPECT_TRUE(plan({"a"}).models.empty());
}

TEST_F(PruneTest, LeavesWhatCannotBeSeen) {
    const fs::path deep = test::make_unreadable_folder(path("b"));
    ModelSummary model;
    model.id = 6;
    model.path = deep;
    while (model.path.size() <= PATH_MAX) model.path += "/" + deep.filename().string();
    model.path += "/6.off";
    models_.push_back(model);
    before_.push_back(model.path);
    EXPECT_FALSE(is_gone(model.path));
    EXPECT_TRUE(plan({"b"}).models.empty());
}

}  // namespace
}  // namespace ossuary::index
