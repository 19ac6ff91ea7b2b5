#include "engine/core/inflate.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/support/packed.h"

namespace ossuary::test {
namespace {

std::string random_text(std::size_t size) {
    std::mt19937 random(1);
    std::string text(size, ' ');
    for (char& c : text) c = static_cast<char>('a' + random() % 26);
    return text;
}

TEST(Inflate, GivesBackWhatWasPacked) {
    for (const std::size_t size : {0UL, 1UL, 1000UL, 1UL << 20, (1UL << 20) + 1, 5'000'000UL}) {
        const std::string text = random_text(size);
        const std::string packed = gzipped(text);
        EXPECT_TRUE(looks_like_gzip(packed));
        const auto unpacked = gunzip(packed, "file");
        ASSERT_TRUE(unpacked) << size << ": " << unpacked.error().message;
        EXPECT_EQ(unpacked->view(), text) << size;
    }
}

TEST(Inflate, TakesSeveralMembers) {
    const auto unpacked = gunzip(gzipped("one ") + gzipped("two ") + gzipped(""), "file");
    ASSERT_TRUE(unpacked);
    EXPECT_EQ(unpacked->view(), "one two ");
}

TEST(Inflate, RefusesEveryTruncation) {
    const std::string packed = gzipped(random_text(300));
    for (std::size_t length = 0; length < packed.size(); ++length) {
        const auto unpacked = gunzip(std::string_view(packed).substr(0, length), "file");
        ASSERT_FALSE(unpacked) << length;
        EXPECT_EQ(unpacked.error().code, ErrorCode::kGzipInvalid);
        EXPECT_EQ(unpacked.error().message.rfind("file, byte ", 0), 0U);
    }
}

TEST(Inflate, RefusesDamageAndWhatFollows) {
    const std::string packed = gzipped(random_text(3000));
    std::string damaged = packed;
    damaged[packed.size() - 6] = static_cast<char>(damaged[packed.size() - 6] ^ 1);  // checksum
    EXPECT_EQ(gunzip(damaged, "file").error().code, ErrorCode::kGzipInvalid);
    damaged = packed;
    damaged[packed.size() / 2] = static_cast<char>(damaged[packed.size() / 2] ^ 0x55);
    EXPECT_EQ(gunzip(damaged, "file").error().code, ErrorCode::kGzipInvalid);
    EXPECT_EQ(gunzip(packed + "more", "file").error().code, ErrorCode::kGzipInvalid);
    EXPECT_EQ(gunzip("no gzip at all", "file").error().code, ErrorCode::kGzipInvalid);
}

TEST(Inflate, StopsAtItsCaps) {
    const std::string zeros = gzipped(std::string(3'000'000, '\0'));
    EXPECT_TRUE(gunzip(zeros, "file"));
    UnpackCaps caps;
    caps.max_bytes = 2'999'999;
    EXPECT_EQ(gunzip(zeros, "file", caps).error().code, ErrorCode::kFileTooLarge);
    caps.max_bytes = 3'000'000;
    EXPECT_TRUE(gunzip(zeros, "file", caps));
    caps.ratio_from = 1000;
    EXPECT_EQ(gunzip(zeros, "file", caps).error().code, ErrorCode::kFileTooLarge);
    EXPECT_TRUE(gunzip(gzipped(random_text(3'000'000)), "file", caps));
}

TEST(Inflate, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(gunzip(gzipped("text"), "file", {}, source.get_token()).error().code,
              ErrorCode::kCancelled);
}

}  // namespace
}  // namespace ossuary::test
