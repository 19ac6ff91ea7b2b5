#include "engine/core/whole_file.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace ossuary {
namespace {

namespace fs = std::filesystem;

class WholeFileTest : public testing::Test {
protected:
    test::TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "some file";
};

TEST_F(WholeFileTest, ReadsWhatWasWritten) {
    const std::string bytes("a\0b\r\n\xFF", 6);
    for (const std::string& each : {bytes, std::string(), std::string(100'000, 'x')}) {
        const auto written = write_whole_file(path_, each);
        ASSERT_TRUE(written) << written.error().message;
        const auto read = read_whole_file(path_);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->view(), each);
    }
}

TEST_F(WholeFileTest, ReadsNoMoreThanItMay) {
    ASSERT_TRUE(write_whole_file(path_, "12345"));
    EXPECT_TRUE(read_whole_file(path_, 5));
    const auto read = read_whole_file(path_, 4);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kFileTooLarge);
    EXPECT_EQ(read.error().message, path_.string() + ": expected at most 4 bytes, found 5");
}

TEST_F(WholeFileTest, SaysWhyItCannotRead) {
    const auto missing = read_whole_file(path_);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::kFileNotFound);
    const auto folder = read_whole_file(folder_.path());
    ASSERT_FALSE(folder);
    EXPECT_EQ(folder.error().code, ErrorCode::kFileUnreadable);
    EXPECT_NE(folder.error().message.find("not a regular file"), std::string::npos);
}

TEST_F(WholeFileTest, SaysWhyItCannotWrite) {
    const auto nowhere = write_whole_file(folder_.path() / "none" / "x", "text");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::kFileUnwritable);
    EXPECT_NE(nowhere.error().message.find("No such file"), std::string::npos);
    // A device that is always full: nothing is said to be written that is not.
    if (fs::exists("/dev/full")) {
        const auto full = write_whole_file("/dev/full", std::string(100'000, 'x'));
        ASSERT_FALSE(full);
        EXPECT_EQ(full.error().code, ErrorCode::kFileUnwritable);
        const auto kept_back = write_whole_file("/dev/full", "x");
        ASSERT_FALSE(kept_back);
        EXPECT_EQ(kept_back.error().code, ErrorCode::kFileUnwritable);
    }
}

}  // namespace
}  // namespace ossuary
