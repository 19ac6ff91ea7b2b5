#include "engine/voxel/npy.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

/// An .npy file with a header of our own wording.
std::string npy(const std::string& header, const std::string& values, int major = 1) {
    std::string bytes("\x93NUMPY", 6);
    bytes += {static_cast<char>(major), '\0'};
    const auto length = header.size() + 1;
    for (int i = 0; i < (major == 1 ? 2 : 4); ++i) {
        bytes.push_back(static_cast<char>((length >> (8 * i)) & 0xff));
    }
    return bytes + header + "\n" + values;
}

std::string dictionary(const std::string& descr, const std::string& order,
                       const std::string& shape) {
    return "{'descr': '" + descr + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
}

void expect_refused(const std::string& bytes, ErrorCode code, const std::string& said) {
    const auto result = parse_npy(bytes, "in.npy");
    ASSERT_FALSE(result.ok()) << said;
    EXPECT_EQ(result.error().code, code) << result.error().message;
    EXPECT_NE(result.error().message.find(said), std::string::npos) << result.error().message;
    EXPECT_EQ(result.error().message.rfind("in.npy: ", 0), 0u) << result.error().message;
}

TEST(Npy, ReadsBackWhatItWrote) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const BitVolume volume =
            test::random_volume({1 + static_cast<int>(seed) * 7, 3, 5}, 0.4, seed);
        const std::string bytes = format_npy(volume);
        EXPECT_EQ((bytes.size() - volume.voxel_count()) % 64, 0u);
        const auto read = parse_npy(bytes, "in.npy");
        ASSERT_TRUE(read.ok()) << read.error().message;
        EXPECT_EQ(*read, volume);
    }
}

TEST(Npy, GoesThroughAFile) {
    const auto path = std::filesystem::path(testing::TempDir()) / "ossuary_npy_test.npy";
    const BitVolume volume = test::torus(8, 3).volume;
    ASSERT_TRUE(write_npy(volume, path).ok());
    const auto read = read_npy(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(*read, volume);
    EXPECT_EQ(read_npy(path).error().code, ErrorCode::kFileNotFound);
    EXPECT_EQ(read_npy(testing::TempDir()).error().code, ErrorCode::kFileUnreadable);
    EXPECT_EQ(write_npy(volume, path / "no" / "such").error().code, ErrorCode::kFileUnwritable);
}

TEST(Npy, TakesAxisZeroAsXInEitherOrder) {
    // Six values of a 3 x 2 x 1 array; only array[2, 0, 0] is set.
    for (const int version : {1, 2, 3}) {
        const auto c = parse_npy(
            npy(dictionary("|u1", "False", "(3, 2, 1)"), std::string("\0\0\0\0\7\0", 6), version),
            "in.npy");
        const auto fortran = parse_npy(
            npy(dictionary("|b1", "True", "(3, 2, 1)"), std::string("\0\0\1\0\0\0", 6), version),
            "in.npy");
        ASSERT_TRUE(c.ok() && fortran.ok());
        EXPECT_EQ(c->count(), 1u);
        EXPECT_TRUE(c->test(2, 0, 0));
        EXPECT_EQ(*c, *fortran);
    }
}

TEST(Npy, TakesKeysInAnyOrderAndEitherQuote) {
    const auto read = parse_npy(
        npy("{\"shape\": (1, 1, 2), \"fortran_order\": False, \"descr\": \"|i1\"}", "\1\xff"),
        "in.npy");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->count(), 2u);
}

TEST(Npy, RefusesWhatIsNotAVolume) {
    const auto code = ErrorCode::kNpyInvalid;
    const std::string good = dictionary("|u1", "False", "(1, 1, 2)");
    expect_refused("", code, "magic");
    expect_refused("\x93NUMP", code, "magic");
    expect_refused(std::string("\x93NUMPY\1", 7), code, "ends within the version");
    expect_refused(std::string("\x93NUMPY\1\0\5", 9), code, "header's length");
    expect_refused(std::string("\x93NUMPY\1\0\5\0{", 11), code, "ends within the header");
    expect_refused(npy(good, "ab", 4), code, "version 4.0");
    expect_refused(npy(good, "a"), code, "found 1 bytes of values, expected 2");
    expect_refused(npy(good, "abc"), code, "found 3 bytes of values, expected 2");
    expect_refused(npy(good + "x", "ab"), code, "after the closing");
    expect_refused(npy("{}", ""), code, "expected the keys");
    expect_refused(npy("not a dictionary", ""), code, "expected '{'");
    expect_refused(npy("{'descr': '|u1', 'descr': '|u1'}", ""), code, "repeated key 'descr'");
    expect_refused(npy("{'magic': 1}", ""), code, "unexpected or repeated key 'magic'");
    expect_refused(npy(dictionary("<f8", "False", "(1, 1, 2)"), "ab"), code, "type '<f8'");
    expect_refused(npy(dictionary("|u1", "Maybe", "(1, 1, 2)"), "ab"), code, "'fortran_order'");
    expect_refused(npy(dictionary("|u1", "False", "(1, -1, 2)"), "ab"), code, "'shape'");
    expect_refused(npy(dictionary("|u1", "False", "(1, 2)"), "ab"), code, "found the shape (1, 2)");
    expect_refused(npy(dictionary("|u1", "False", "(1, 0, 2)"), ""), code, "(1, 0, 2)");
    expect_refused(npy(dictionary("|u1", "False", "(1, 1, 2"), "ab"), code, "'shape'");
    expect_refused(npy(dictionary("|u1", "False", "(1, 1, 99999999999999999999)"), "ab"), code,
                   "'shape'");
}

TEST(Npy, RefusesWhatIsTooLargeBeforeLookingForTheValues) {
    const auto code = ErrorCode::kVolumeTooLarge;
    expect_refused(npy(dictionary("|u1", "False", "(5000, 1, 1)"), ""), code, "at most 4096");
    expect_refused(npy(dictionary("|u1", "False", "(4096, 4096, 4096)"), ""), code, "voxels");
    const auto capped = parse_npy(npy(dictionary("|u1", "False", "(2, 2, 2)"), "12345678"),
                                  "in.npy", {.max_voxels = 7});
    ASSERT_FALSE(capped.ok());
    EXPECT_EQ(capped.error().code, code);
}

TEST(Npy, NeverCrashesOnATruncatedOrAlteredFile) {
    const std::string good = format_npy(test::ball(3).volume);
    for (std::size_t length = 0; length < good.size(); ++length) {
        EXPECT_FALSE(parse_npy(good.substr(0, length), "in.npy").ok()) << length;
    }
    for (std::size_t i = 0; i < 128; ++i) {
        for (const int change : {1, 32, 128}) {
            std::string altered = good;
            altered[i] = static_cast<char>(altered[i] ^ change);
            const auto result = parse_npy(altered, "in.npy");
            EXPECT_TRUE(!result.ok() || result->voxel_count() == 10u * 10u * 10u);
        }
    }
}

}  // namespace
}  // namespace ossuary::voxel
