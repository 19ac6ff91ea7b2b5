#include "engine/core/error_code.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace ossuary {
namespace {

TEST(ErrorCode, HasUniqueNames) {
    std::set<std::string_view> names;
    for (const ErrorCodeName& row : kErrorCodeNames) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name << " is used twice";
    }
}

TEST(ErrorCode, IsNamedInSnakeCase) {
    for (const ErrorCodeName& row : kErrorCodeNames) {
        ASSERT_FALSE(row.name.empty());
        EXPECT_TRUE(row.name.front() >= 'a' && row.name.front() <= 'z') << row.name;
        EXPECT_NE(row.name.back(), '_') << row.name;
        EXPECT_EQ(row.name.find("__"), std::string_view::npos) << row.name;
        EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                  std::string_view::npos)
            << row.name;
    }
}

TEST(ErrorCode, FindsItsOwnName) {
    for (const ErrorCodeName& row : kErrorCodeNames) EXPECT_EQ(to_string(row.code), row.name);
    EXPECT_EQ(to_string(ErrorCode::kOffIndexOutOfRange), "off_index_out_of_range");
}

}  // namespace
}  // namespace ossuary
