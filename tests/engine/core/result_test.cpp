#include "engine/core/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace ossuary {
namespace {

Result<int> half(int number) {
    if (number % 2 != 0) return {ErrorCode::kInvalidArgument, "expected an even number"};
    return number / 2;
}

TEST(Result, HoldsAValueOrAnError) {
    const Result<int> good = half(8);
    ASSERT_TRUE(good.ok());
    EXPECT_TRUE(static_cast<bool>(good));
    EXPECT_EQ(*good, 4);
    const Result<int> bad = half(7);
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().code, ErrorCode::kInvalidArgument);
    EXPECT_EQ(bad.error().message, "expected an even number");
}

TEST(Result, PassesAnErrorOnToAnotherType) {
    const Result<std::vector<int>> bad = half(3).error();
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().message, "expected an even number");
}

TEST(Result, GivesItsValueAway) {
    Result<std::unique_ptr<int>> owner = std::make_unique<int>(5);
    const std::unique_ptr<int> taken = *std::move(owner);
    EXPECT_EQ(*taken, 5);
}

TEST(Result, ReachesMembersOfItsValue) {
    Result<std::vector<int>> numbers = std::vector<int>{1, 2, 3};
    numbers->push_back(4);
    EXPECT_EQ(numbers->size(), 4u);
    EXPECT_EQ(numbers.value().back(), 4);
}

TEST(Result, CanStandForSuccessWithoutAValue) {
    const Result<void> good;
    EXPECT_TRUE(good);
    const Result<void> bad = Error{ErrorCode::kCancelled, "stopped"};
    ASSERT_FALSE(bad.ok());
    EXPECT_EQ(bad.error().code, ErrorCode::kCancelled);
}

#ifndef NDEBUG
TEST(ResultDeathTest, TakesTheValueOfAnErrorForABug) {
    const Result<int> bad = half(1);
    EXPECT_DEATH(static_cast<void>(bad.value()), "ok");
}
#endif

}  // namespace
}  // namespace ossuary
