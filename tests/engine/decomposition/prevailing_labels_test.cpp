#include "engine/decomposition/prevailing_labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ossuary::decomposition {
namespace {

using testing::ElementsAre;

std::vector<std::int32_t> prevailing(std::size_t groups, const std::vector<std::uint32_t>& group_of,
                                     const std::vector<std::int32_t>& label_of,
                                     const std::vector<double>& area) {
    return prevailing_labels(groups, group_of, label_of, area);
}

TEST(PrevailingLabels, CountsAreaAndNotTriangles) {
    EXPECT_THAT(prevailing(2, {0, 0, 0, 1}, {4, 4, 7, 2}, {1.0, 1.0, 2.5, 1.0}), ElementsAre(7, 2));
}

TEST(PrevailingLabels, PrefersTheLowestAmongEquals) {
    EXPECT_THAT(prevailing(1, {0, 0}, {5, 3}, {1.0, 1.0}), ElementsAre(3));
}

TEST(PrevailingLabels, FindsNoneWhereNoTriangleHasOne) {
    EXPECT_THAT(prevailing(3, {0, 2}, {-1, 6}, {1.0, 1.0}), ElementsAre(-1, -1, 6));
}

TEST(PrevailingLabels, TakesALabelWithoutAreaRatherThanNone) {
    EXPECT_THAT(prevailing(1, {0, 0}, {-1, 6}, {1.0, 0.0}), ElementsAre(6));
}

}  // namespace
}  // namespace ossuary::decomposition
