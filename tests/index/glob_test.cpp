#include "index/glob.h"

#include <gtest/gtest.h>

#include <chrono>

namespace ossuary::index {
namespace {

bool fits(std::string_view pattern, std::string_view path, bool is_folder = false) {
    const auto glob = Glob::parse(pattern);
    EXPECT_TRUE(glob) << pattern;
    return glob && glob->matches(path, is_folder);
}

TEST(Glob, WithoutASlashMeansNamesAtAnyDepth) {
    EXPECT_TRUE(fits("draft*", "draft1.off"));
    EXPECT_TRUE(fits("draft*", "a/b/draft.off"));
    EXPECT_FALSE(fits("draft*", "a/my draft.off"));
    EXPECT_FALSE(fits("a*", "a/b.off"));
    EXPECT_TRUE(fits("?.off", "a/b.off"));
    EXPECT_FALSE(fits("?.off", "a/bb.off"));
    EXPECT_FALSE(fits("A.off", "a.off"));
    EXPECT_TRUE(fits("*", "anything/at/all"));
    EXPECT_TRUE(fits("**", "anything/at/all"));
}

TEST(Glob, WithASlashMeansPathsFromTheRoot) {
    EXPECT_TRUE(fits("old/*.off", "old/a.off"));
    EXPECT_FALSE(fits("old/*.off", "very/old/a.off"));
    EXPECT_FALSE(fits("old/*.off", "old/b/a.off"));
    EXPECT_TRUE(fits("/a.off", "a.off"));
    EXPECT_FALSE(fits("/a.off", "b/a.off"));
    EXPECT_FALSE(fits("a?b", "a/b"));
}

TEST(Glob, TwoStarsMeanAnyNumberOfFolders) {
    EXPECT_TRUE(fits("**/old/*", "old/a"));
    EXPECT_TRUE(fits("**/old/*", "x/y/old/a"));
    EXPECT_FALSE(fits("**/old/*", "x/bold/a"));
    EXPECT_FALSE(fits("**/old/*", "old/a/b"));
    EXPECT_TRUE(fits("old/**", "old/a/b"));
    EXPECT_FALSE(fits("old/**", "old"));
    EXPECT_FALSE(fits("old/**", "older/a"));
    EXPECT_TRUE(fits("a/**/b", "a/b"));
    EXPECT_TRUE(fits("a/**/b", "a/x/y/b"));
    EXPECT_FALSE(fits("a/**/b", "a/xb"));
    EXPECT_TRUE(fits("**/a/**", "x/a/y/z"));
    EXPECT_FALSE(fits("x**y/z", "xa/by/z")) << "only two stars alone are folders";
    EXPECT_TRUE(fits("x**y/z", "xaby/z"));
}

TEST(Glob, WithASlashAtTheEndMeansFolders) {
    EXPECT_TRUE(fits("old/", "a/old", true));
    EXPECT_FALSE(fits("old/", "a/old", false));
    EXPECT_TRUE(fits("a/old/", "a/old", true));
    EXPECT_FALSE(fits("a/old/", "b/a/old", true));
}

TEST(Glob, KnowsSetsAndWhatIsMeantAsItIs) {
    EXPECT_TRUE(fits("[a-c]1", "b1"));
    EXPECT_FALSE(fits("[a-c]1", "d1"));
    EXPECT_TRUE(fits("[!a-c]1", "d1"));
    EXPECT_TRUE(fits("[^a-c]1", "d1"));
    EXPECT_FALSE(fits("x[!a]y/z", "x/y/z")) << "no set holds the slash";
    EXPECT_TRUE(fits("[]a]", "]"));
    EXPECT_TRUE(fits("[a-]", "-"));
    EXPECT_TRUE(fits("\\*.off", "*.off"));
    EXPECT_FALSE(fits("\\*.off", "a.off"));
    EXPECT_TRUE(fits("\\[1].off", "[1].off"));
}

TEST(Glob, CountsCharactersAndTakesBytesThatAreNone) {
    EXPECT_TRUE(fits("h?ron", "h\xC3\xA9ron"));
    EXPECT_TRUE(fits("h[\xC3\xA8-\xC3\xAA]ron", "h\xC3\xA9ron"));
    EXPECT_TRUE(fits("b?r", "b\xE4r"));
    EXPECT_TRUE(fits("b\xE4r", "b\xE4r"));
}

TEST(Glob, RefusesWhatIsNoPattern) {
    for (const char* pattern : {"", "/", "[a", "a[!]", "a\\"}) {
        const auto glob = Glob::parse(pattern);
        ASSERT_FALSE(glob) << pattern;
        EXPECT_EQ(glob.error().code, ErrorCode::kInvalidArgument);
    }
}

// Matchers that try one way after the other take 2^40 steps for this.
TEST(Glob, TakesNoLongerForManyStars) {
    std::string pattern;
    for (int i = 0; i < 40; ++i) pattern += "*a";
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(fits(pattern + "b", std::string(4000, 'a')));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

}  // namespace
}  // namespace ossuary::index
