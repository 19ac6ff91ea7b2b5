#include "server/progress.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

using server::Progress;

const std::string kToken = "0123456789abcdef0123456789abcdef";

TEST(Progress, KnowsTheStageOfARunningSearchAlone) {
    Progress progress;
    EXPECT_FALSE(progress.find(kToken));
    {
        Progress::Report report(progress, kToken);
        EXPECT_EQ(progress.find(kToken), "wait");
        report.stage("thin");
        EXPECT_EQ(progress.find(kToken), "thin");
        {
            Progress::Report second(progress, kToken);
            second.stage("rank");
            EXPECT_EQ(progress.find(kToken), "thin") << "the first one's token";
        }
        EXPECT_EQ(progress.find(kToken), "thin");
    }
    EXPECT_FALSE(progress.find(kToken));
    Progress::Report silent(progress, "");
    silent.stage("thin");
    EXPECT_FALSE(progress.find(""));
}

TEST(Progress, KnowsATokenFromOtherTexts) {
    EXPECT_TRUE(server::is_token(kToken));
    for (const std::string& text : {std::string(), kToken + "0", kToken.substr(1),
                                    "G" + kToken.substr(1), "A" + kToken.substr(1)}) {
        EXPECT_FALSE(server::is_token(text)) << text;
    }
}

class RunningSearch : public testing::Test {
protected:
    TemporaryFolder folder_;
    TestServer server_{copy_of_built_index(folder_.path())};

    [[nodiscard]] nlohmann::json stage() const {
        return server_.json(get("/v1/progress/" + kToken))["stage"];
    }
};

TEST_F(RunningSearch, TellsItsStage) {
    EXPECT_TRUE(stage().is_null());
    std::set<std::string> seen;
    std::atomic<bool> done = false;
    std::jthread search([&] {
        for (int i = 0; i < 3; ++i) {
            server_.json(post("/v1/search?include=mesh&progress=" + kToken, built_models()[4].off));
        }
        done = true;
    });
    while (!done) {
        if (const auto told = stage(); !told.is_null()) seen.insert(told.get<std::string>());
    }
    EXPECT_TRUE(stage().is_null());
    EXPECT_GE(seen.size(), 2u);
    const std::set<std::string> known = {"wait",
                                         "read",
                                         "voxelize",
                                         "distance_transform",
                                         "thin",
                                         "refine",
                                         "surface",
                                         "describe_skeleton",
                                         "turned_skeletons",
                                         "rank",
                                         "explain",
                                         "global_descriptors"};
    for (const std::string& each : seen) EXPECT_TRUE(known.contains(each)) << each;
}

TEST_F(RunningSearch, TakesRandomNumbersAlone) {
    for (const char* bad : {"1", "", "x"}) {
        const auto problem = server_.json(
            post("/v1/search?progress=" + std::string(bad), built_models()[4].off), 400);
        EXPECT_EQ(problem["parameter"], "progress");
    }
}

}  // namespace
}  // namespace ossuary::test
