#include "engine/decomposition/seg_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ossuary::decomposition {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(SegFile, ReadsALabelALineAndRenumbers) {
    const auto read = parse_seg("7\r\n7\n\n0\n3\n7", "x.seg", 5);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_THAT(read->labels, ElementsAre(0, 0, 1, 2, 0));
    EXPECT_EQ(read->parts, 3u);
}

TEST(SegFile, ReadsWhatItWrites) {
    const Segmentation segmentation = dense_segmentation({0, 1, 1, 2, 0});
    EXPECT_EQ(to_seg(segmentation), "0\n1\n1\n2\n0\n");
    EXPECT_EQ(*parse_seg(to_seg(segmentation), "x.seg", 5), segmentation);
}

TEST(SegFile, RefusesAnotherNumberOfLabels) {
    for (const char* text : {"", "0\n", "0\n1\n2\n"}) {
        const auto read = parse_seg(text, "x.seg", 2);
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_EQ(read.error().code, ErrorCode::kSegInvalid);
        EXPECT_THAT(read.error().message, HasSubstr("2 faces"));
    }
}

TEST(SegFile, NamesTheLineOfWhatIsNoLabel) {
    for (const char* text : {"0\n1x\n", "0\n-1\n", "0\n1.5\n", "0\n99999999999\n", "0\nleg\n"}) {
        const auto read = parse_seg(text, "x.seg", 2);
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_EQ(read.error().code, ErrorCode::kSegInvalid);
        EXPECT_THAT(read.error().message, HasSubstr("line 2"));
    }
}

TEST(SegFile, SaysThatAFileIsMissing) {
    const auto read = read_seg("/nowhere/x.seg", 1);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::kFileNotFound);
}

}  // namespace
}  // namespace ossuary::decomposition
