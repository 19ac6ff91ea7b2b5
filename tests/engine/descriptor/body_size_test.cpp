#include "engine/descriptor/body_size.h"

#include <gtest/gtest.h>

namespace ossuary::descriptor {
namespace {

TEST(BodySize, IsTheLogarithmOfTheFactorBetweenTwo) {
    const auto one = body_size(0.37), twice = body_size(0.74);
    ASSERT_EQ(one.size(), kBodySizeSize);
    EXPECT_EQ(body_size_distance(one, one), 0.0);
    EXPECT_NEAR(body_size_distance(one, twice), std::log(2.0), 1e-6);
    EXPECT_EQ(body_size_distance(one, twice), body_size_distance(twice, one));
    EXPECT_EQ(body_size(1.0), (std::vector<std::uint8_t>{0, 0, 0, 0}));
    EXPECT_EQ(body_size(0.0), body_size(1.0));
    EXPECT_EQ(body_size(std::exp(1.0)), (std::vector<std::uint8_t>{0, 0, 0x80, 0x3F}));
}

TEST(BodySize, TakesFilesOfAnyUnit) {
    EXPECT_NEAR(body_size_distance(body_size(1e-30), body_size(1e30)), 60.0 * std::log(10.0), 1e-3);
}

}  // namespace
}  // namespace ossuary::descriptor
