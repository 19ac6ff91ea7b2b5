#include "index/reader/three_mf_extensions.h"

#include <gtest/gtest.h>

namespace ossuary::index {
namespace {

using Names = std::vector<std::string>;

TEST(ThreeMfExtensions, AreNamedByWhatTheirPrefixesStandFor) {
    EXPECT_EQ(required_extensions(R"(<?xml version="1.0"?><model unit="inch" xmlns:a="http://a" )"
                                  R"(xmlns:b='http://b' requiredextensions="b a">)"),
              (Names{"http://b", "http://a"}));
    EXPECT_EQ(required_extensions("<model\n requiredextensions = \"p\"\n xmlns:p=\"http://p\">"),
              Names{"http://p"});
    EXPECT_EQ(required_extensions(R"(<model requiredextensions="gone">)"), Names{"gone"});
}

TEST(ThreeMfExtensions, AreNoneWhereNothingIsSaid) {
    for (const char* text : {"", "<model>", "<model requiredextensions=\"\">", "<mode",
                             "<model requiredextensions=", "<model xrequiredextensions=\"p\">",
                             "<model requiredextensions=\"p"}) {
        EXPECT_TRUE(required_extensions(text).empty()) << text;
    }
}

}  // namespace
}  // namespace ossuary::index
