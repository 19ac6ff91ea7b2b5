#include "server/problem.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace ossuary::server {
namespace {

TEST(ProblemTable, HasARowForEveryErrorCode) {
    for (const ErrorCodeName& each : kErrorCodeNames) {
        EXPECT_EQ(problem_row(each.code).code, each.name);
    }
}

TEST(ProblemTable, HasARowForEveryRequestFault) {
    std::set<std::string_view> codes;
    for (int i = 0; i <= static_cast<int>(RequestFault::kShuttingDown); ++i) {
        const ProblemRow& row = problem_row(static_cast<RequestFault>(i));
        EXPECT_TRUE(codes.insert(row.code).second) << row.code << ", fault " << i;
    }
}

TEST(ProblemTable, NamesEachCodeOnceWithAnErrorStatusAndATitle) {
    std::set<std::string_view> codes;
    for (const ProblemRow& row : problem_table()) {
        EXPECT_TRUE(codes.insert(row.code).second) << row.code << " is there twice";
        EXPECT_GE(row.status, 400) << row.code;
        EXPECT_LT(row.status, 600) << row.code;
        EXPECT_FALSE(row.title.empty()) << row.code;
        EXPECT_EQ(row.status == 503, row.retry_after_seconds > 0) << row.code;
    }
}

TEST(ProblemDocument, SaysWhatWentWrong) {
    const Response response =
        to_response(problem({ErrorCode::kOffTruncated, "line 3: expected 3 numbers, found 2"}),
                    "/v1/search", "id-1");
    EXPECT_EQ(response.status, 422);
    EXPECT_EQ(response.content_type, "application/problem+json");
    const auto json = nlohmann::json::parse(response.body);
    EXPECT_EQ(json["type"], "about:blank");
    EXPECT_EQ(json["status"], 422);
    EXPECT_EQ(json["code"], "off_truncated");
    EXPECT_EQ(json["detail"], "line 3: expected 3 numbers, found 2");
    EXPECT_EQ(json["instance"], "/v1/search");
    EXPECT_EQ(json["request_id"], "id-1");
    EXPECT_FALSE(json["title"].get<std::string>().empty());
}

TEST(ProblemDocument, KeepsTheServersOwnTroublesToTheLog) {
    const Problem found = problem({ErrorCode::kIndexCorrupt, "/home/x/secret.ossuary: damaged"});
    const Response response = to_response(found, "/", "id");
    EXPECT_EQ(response.status, 500);
    EXPECT_EQ(response.body.find("secret"), std::string::npos);
    EXPECT_NE(found.cause.find("secret"), std::string::npos);
}

TEST(ProblemDocument, SurvivesBytesThatAreNotUtf8) {
    const Response response =
        to_response(problem(RequestFault::kFileNotServed, "\xff\xfe"), "/\xff", "id");
    EXPECT_TRUE(nlohmann::json::accept(response.body));
}

}  // namespace
}  // namespace ossuary::server
