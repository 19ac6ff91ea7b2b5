#include "index/model_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

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
    FoundFiles walk(const std::vector<fs::path>& paths,
                    const std::vector<const char*>& exclude = {}) {
        WalkOptions options;
        for (const char* pattern : exclude) options.exclude.push_back(*Glob::parse(pattern));
        auto files = find_model_files(paths, options);
        EXPECT_TRUE(files);
        return *std::move(files);
    }
    std::vector<std::string> names(const FoundFiles& found) {
        std::vector<std::string> names;
        for (const fs::path& file : found.files) names.push_back(file.lexically_relative(root_));
        return names;
    }
    std::vector<std::string> found(const std::vector<fs::path>& paths,
                                   const std::vector<const char*>& exclude = {}) {
        return names(walk(paths, exclude));
    }
    void write(const std::string& name) {
        fs::create_directories((root_ / name).parent_path());
        test::write_file(root_ / name, name);
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

TEST_F(ModelFiles, AreReportedMissingWhenNamedAndNotThere) {
    const FoundFiles found = walk({root_, root_ / "none"});
    EXPECT_EQ(found.missing, (std::vector<fs::path>{root_ / "none"}));
    EXPECT_EQ(found.files.size(), 4U);
}

TEST_F(ModelFiles, AreNotSoughtUnderHiddenNames) {
    for (const char* name : {"._a.off", ".Trashes/1.off", "b/@eaDir/1.off", "#recycle/1.off",
                             "lost+found/1.off", "$RECYCLE.BIN/1.off", "$Recycle.Bin/2.off",
                             "System Volume Information/1.off", "__MACOSX/b/._1.off"}) {
        write(name);
    }
    const FoundFiles found = walk({root_});
    EXPECT_EQ(names(found),
              (std::vector<std::string>{"a.off", "b/10.OFF", "b/2.off", "b/deep/1.off"}));
    EXPECT_EQ(found.passed_over.hidden, 9U) << "a folder counts once";
    EXPECT_EQ(found.passed_over.other_files, 1U);
}

TEST_F(ModelFiles, AreFoundUnderHiddenNamesThatAreNamed) {
    write("._a.off");
    write(".store/1.off");
    write(".store/.deeper/2.off");
    EXPECT_EQ(this->found({root_ / "._a.off"}), (std::vector<std::string>{"._a.off"}));
    EXPECT_EQ(this->found({root_ / ".store"}), (std::vector<std::string>{".store/1.off"}));
    EXPECT_EQ(this->found({root_ / "b" / "deep", root_ / ".store"}),
              (std::vector<std::string>{".store/1.off", "b/deep/1.off"}));
}

TEST_F(ModelFiles, AreLeftOutByPatterns) {
    EXPECT_EQ(found({root_}, {"b/**"}), (std::vector<std::string>{"a.off"}));
    EXPECT_EQ(found({root_}, {"deep", "*.OFF"}), (std::vector<std::string>{"a.off", "b/2.off"}));
    EXPECT_EQ(found({root_ / "b"}, {"b/**"}).size(), 3U) << "paths count from the folder named";
    EXPECT_EQ(found({root_ / "a.off", root_ / "b" / "2.off"}, {"2*"}),
              (std::vector<std::string>{"a.off"}));
    EXPECT_EQ(walk({root_}, {"deep/", "a*"}).passed_over.excluded, 2U);
}

TEST_F(ModelFiles, AreFoundThroughLinksToFoldersOnce) {
    const fs::path outside = folder_.path() / "outside";
    fs::create_directories(outside / "sub");
    test::write_file(outside / "x.off", "x");
    test::write_file(outside / "sub" / "y.off", "y");
    fs::create_directory_symlink(outside, root_ / "first");
    fs::create_directory_symlink(outside, root_ / "second");
    fs::create_directory_symlink(outside / "sub", root_ / "third");
    fs::create_directory_symlink(root_ / "b", root_ / "again");
    const FoundFiles found = walk({root_});
    EXPECT_EQ(names(found),
              (std::vector<std::string>{"a.off", "b/10.OFF", "b/2.off", "b/deep/1.off",
                                        "first/sub/y.off", "first/x.off"}));
    EXPECT_EQ(found.passed_over.seen_before, 3U);
}

TEST_F(ModelFiles, AreFoundOnceWhereLinksLeadBack) {
    fs::create_directory_symlink(root_, root_ / "b" / "loop");
    fs::create_directory_symlink("..", root_ / "b" / "deep" / "up");
    fs::create_directory_symlink(folder_.path(), root_ / "above");  // would lead to everything
    fs::create_directory_symlink("self", root_ / "self");
    const fs::path one = folder_.path() / "one", two = folder_.path() / "two";
    fs::create_directories(one);
    fs::create_directories(two);
    test::write_file(one / "1.off", "1");
    fs::create_directory_symlink(two, one / "two");
    fs::create_directory_symlink(one, two / "one");
    fs::create_directory_symlink(one, root_ / "one");
    const FoundFiles found = walk({root_});
    EXPECT_EQ(names(found), (std::vector<std::string>{"a.off", "b/10.OFF", "b/2.off",
                                                      "b/deep/1.off", "one/1.off"}));
    EXPECT_EQ(found.passed_over.broken_links, 1U) << "a link to itself";
    EXPECT_EQ(found.passed_over.seen_before, 4U);
}

TEST_F(ModelFiles, AreTakenUnderTheirOwnPathsWhereSeveralLead) {
    fs::create_symlink(root_ / "a.off", root_ / "0_link.off");
    test::write_file(folder_.path() / "out.off", "o");
    fs::create_symlink(folder_.path() / "out.off", root_ / "b" / "k.off");
    fs::create_symlink(folder_.path() / "out.off", root_ / "b" / "j.off");
    fs::create_symlink(root_ / "nowhere.off", root_ / "broken.off");
    fs::create_hard_link(root_ / "a.off", root_ / "hard.off");
    const FoundFiles found = walk({root_});
    EXPECT_EQ(names(found), (std::vector<std::string>{"a.off", "b/10.OFF", "b/2.off",
                                                      "b/deep/1.off", "b/j.off", "hard.off"}));
    EXPECT_EQ(found.seen_before,
              (std::vector<fs::path>{root_ / "0_link.off", root_ / "b" / "k.off"}));
    EXPECT_EQ(found.broken_links, (std::vector<fs::path>{root_ / "broken.off"}));

    fs::create_directory_symlink(root_ / "b", folder_.path() / "a_link");
    EXPECT_EQ(this->found({folder_.path() / "a_link", root_}), names(found));
    EXPECT_EQ(this->found({folder_.path() / "a_link" / "2.off", root_ / "b" / "2.off"}),
              (std::vector<std::string>{"b/2.off"}));
    EXPECT_EQ(walk({folder_.path() / "a_link"}).files.size(), 4U) << "a link that is named";
}

TEST_F(ModelFiles, AreFoundBesideFoldersThatCannotBeRead) {
    const fs::path way_down = test::make_unreadable_folder(root_ / "b");
    const FoundFiles found = walk({root_});
    EXPECT_EQ(found.files.size(), 4U);
    ASSERT_EQ(found.unreadable.size(), 1U);
    EXPECT_TRUE(is_under(found.unreadable[0].path, {way_down}));
    EXPECT_EQ(found.unreadable[0].error.code, ErrorCode::kFileUnreadable);
}

TEST_F(ModelFiles, AreNoPipes) {
    ASSERT_EQ(::mkfifo((root_ / "pipe.off").c_str(), 0600), 0);
    const FoundFiles found = walk({root_});
    EXPECT_EQ(found.files.size(), 4U);
    EXPECT_EQ(found.passed_over.special, 1U);
}

TEST_F(ModelFiles, AreNoLongerSoughtOnceStopped) {
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = find_model_files({root_}, {}, stop.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
}

TEST_F(ModelFiles, AreJudgedByTheirPathsAsTheWalkDoes) {
    WalkOptions options;
    options.exclude = {*Glob::parse("draft*"), *Glob::parse("old/**")};
    const std::vector<fs::path> roots = {"/m", "/m/.kept"};
    for (const char* path : {"/m/.x/a.off", "/m/b/._a.off", "/m/draft.off", "/m/b/drafts/a.off",
                             "/m/old/b/a.off", "/m/.kept/.x/a.off"}) {
        EXPECT_TRUE(is_passed_over(path, roots, options)) << path;
    }
    for (const char* path : {"/m/a.off", "/m/b/old/a.off", "/m/.kept/a.off", "/n/.x/a.off"}) {
        EXPECT_FALSE(is_passed_over(path, roots, options)) << path;
    }
    EXPECT_TRUE(is_passed_over("/m/draft.off", {"/m/draft.off"}, options)) << "named, but excluded";
    EXPECT_FALSE(is_passed_over("/m/.x.off", {"/m/.x.off"}, options)) << "named";
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

}  // namespace
}  // namespace ossuary::index
