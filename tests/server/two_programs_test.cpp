// The server and the command line on one index at once.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <thread>

#include "tests/index/cli/run_program.h"
#include "tests/index/file_locks.h"
#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class TwoPrograms : public testing::Test {
protected:
    TwoPrograms() { std::ofstream(folder_.path() / "key") << kKey << '\n'; }

    static constexpr const char* kKey = "a-key-for-tests-0123456789";

    TestServer::Change with_key() {
        return [this](server::ServerOptions& options) {
            options.admin_key_file = folder_.path() / "key";
        };
    }
    static std::string bearer() { return "Authorization: Bearer " + std::string(kKey) + "\r\n"; }

    /// Puts a file with a model that is in no other into a folder of its own, which it returns.
    fs::path write_model(const std::string& name) {
        const fs::path folder = folder_.path() / name;
        fs::create_directory(folder);
        std::ofstream(folder / (name + ".off")) << built_models()[0].off << "# " << name << '\n';
        return folder;
    }
    ProgramResult run(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--index", index_.string()});
        return run_ossuary(arguments, folder_.path());
    }
    static bool finished(const TestServer& server, const std::string& location) {
        const auto job = server.json(get(location));
        return job["state"] == "done" || job["state"] == "failed";
    }
    static std::set<std::string> names(const nlohmann::json& models) {
        std::set<std::string> names;
        for (const auto& model : models) names.insert(model["name"].get<std::string>());
        return names;
    }

    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
};

TEST_F(TwoPrograms, TheServerKeepsItsLocks) {
    for (const TestServer::Change& change : {TestServer::Change(), with_key()}) {
        const TestServer server(index_, change);
        EXPECT_TRUE(holds_lock(index_)) << "after the start";
        EXPECT_EQ(server.ask(get("/v1/evaluations/hybrid")).status, 200);
        EXPECT_TRUE(holds_lock(index_)) << "after an evaluation";
        EXPECT_EQ(server.ask(post("/v1/search", built_models()[0].off)).status, 200);
        EXPECT_EQ(server.ask(get("/readyz")).status, 200);
        EXPECT_TRUE(holds_lock(index_)) << "after a search";
    }
    EXPECT_FALSE(holds_lock(index_));
}

TEST_F(TwoPrograms, TheServerWorksOnAfterTheOtherHasClosedTheIndex) {
    const TestServer server(index_);
    EXPECT_EQ(server.ask(get("/v1/evaluations/hybrid")).status, 200);
    for (const char* name : {"one", "two"}) {
        const auto indexed = run({"index", write_model(name).string()});
        ASSERT_EQ(indexed.exit_status, 0) << indexed.err;
        EXPECT_EQ(server.json(get("/v1/models?name=" + std::string(name)))["total"], 1);
        EXPECT_EQ(server.ask(get("/v1/evaluations/hybrid")).status, 200);
    }
    EXPECT_EQ(run({"verify"}).exit_status, 0);
}

TEST_F(TwoPrograms, WriteByTurnsAndLoseNothing) {
    std::set<std::string> expected = {"balla", "ballb", "ringa", "ringb", "treea", "treeb"};
    {
        const TestServer server(index_, with_key());
        std::vector<std::string> jobs;
        for (int round = 0; round < 4; ++round) {
            const std::string number = std::to_string(round);
            for (const std::string& name : {"up" + number, "upper" + number}) {
                const RawAnswer added =
                    server.ask(post("/v1/models?name=" + name,
                                    built_models()[0].off + "# " + name + "\n", bearer()));
                ASSERT_EQ(added.status, 202) << added.body;
                jobs.push_back(added.header("Location"));
                expected.insert(name);
            }
            // Beside the uploads that are being indexed.
            const std::string file = "file" + number;
            const auto indexed = run({"index", write_model(file).string()});
            ASSERT_EQ(indexed.exit_status, 0) << indexed.err;
            expected.insert(file);
            EXPECT_EQ(server.ask(get("/v1/evaluations/skeleton")).status, 200);
            for (const std::string& job : jobs) {
                while (!finished(server, job)) std::this_thread::sleep_for(10ms);
                EXPECT_EQ(server.json(get(job))["state"], "done");
            }
            EXPECT_EQ(names(server.json(get("/v1/models"))["models"]), expected);
            EXPECT_EQ(names(run({"models", "--json"}).json()["models"]), expected);
        }
    }
    const auto verified = run({"verify"});
    EXPECT_EQ(verified.exit_status, 0) << verified.out;
    EXPECT_EQ(names(run({"models", "--json"}).json()["models"]), expected);
}

}  // namespace
}  // namespace ossuary::test
