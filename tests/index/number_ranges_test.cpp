#include "index/number_ranges.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ossuary::index {
namespace {

TEST(NumberRanges, HoldTheCountsThatTheirNamesSay) {
    const std::vector<std::pair<std::uint32_t, std::string_view>> branches = {
        {0, "0"},        {1, "1-4"},    {4, "1-4"},          {5, "5-8"},
        {8, "5-8"},      {9, "9-16"},   {16, "9-16"},        {17, "17-32"},
        {128, "65-128"}, {129, "129-"}, {0xFFFFFFFF, "129-"}};
    for (const auto& [count, name] : branches) {
        EXPECT_EQ(kBranchRanges[branch_range(count)], name) << count;
    }
    const std::vector<std::pair<std::uint32_t, std::string_view>> loops = {
        {0, "0"}, {1, "1"}, {2, "2"}, {3, "3-4"}, {4, "3-4"}, {5, "5-8"}, {17, "17-"}};
    for (const auto& [count, name] : loops)
        EXPECT_EQ(kLoopRanges[loop_range(count)], name) << count;
}

TEST(NumberRanges, HoldTheSidesThatTheirNamesSay) {
    const auto name = [](double side, double metres) {
        return extent_ranges()[extent_range(side, metres)];
    };
    EXPECT_EQ(name(0.0, 0.0), "0-0.001");
    EXPECT_EQ(name(0.5, 0.0), "0.1-1");
    EXPECT_EQ(name(1.0, 0.0), "1-10");
    EXPECT_EQ(name(1e6, 0.0), "1000000-");
    EXPECT_EQ(name(1e300, 0.0), "1000000-");
    EXPECT_EQ(name(0.1, 1.0), "100-1000mm") << "however 0.1 is rounded";
    EXPECT_EQ(name(10.0, 0.0254), "100-1000mm");
    EXPECT_EQ(name(99.9, 1e-3), "10-100mm");
    EXPECT_EQ(extent_ranges().size(), 22u);
    for (std::size_t i = 0; i < extent_ranges().size(); ++i) {
        EXPECT_EQ(find_range(extent_ranges(), extent_ranges()[i]), i);
    }
    EXPECT_FALSE(find_range(kBranchRanges, "5"));
}

}  // namespace
}  // namespace ossuary::index
