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
    {
        // Jobs are the index's, whichever server took them.
        const TestServer other(index_, with_key());
        const RawAnswer answer = other.ask(get("/v1/jobs?limit=500", bearer()));
        ASSERT_EQ(answer.status, 200) << answer.body;
        const auto listed = nlohmann::json::parse(answer.body)["jobs"];
        ASSERT_EQ(listed.size(), 8u);
        EXPECT_EQ(listed[0]["name"], "upper3") << "the newest first";
        EXPECT_GT(listed[0]["size"], 0);
        for (const auto& job : listed) {
            EXPECT_EQ(job["state"], "done");
            EXPECT_TRUE(job["error"].is_null());
            EXPECT_TRUE(job["finished_at"].is_string());
        }
        EXPECT_EQ(nlohmann::json::parse(other.ask(get("/v1/jobs?limit=1", bearer())).body)["jobs"],
                  nlohmann::json::array({listed[0]}));
    }
    const auto verified = run({"verify"});
    EXPECT_EQ(verified.exit_status, 0) << verified.out;
    EXPECT_EQ(names(run({"models", "--json"}).json()["models"]), expected);
}

/// Asks until the models' names are these; fails where they never become so.
void expect_to_see(const TestServer& server, const std::set<std::string>& expected) {
    std::set<std::string> seen;
    RawAnswer answer;
    for (int i = 0; i < 1000 && seen != expected; ++i) {
        answer = server.ask(get("/v1/models"));
        // 503 with Retry-After is right while the files change places.
        ASSERT_TRUE(answer.status == 200 || answer.status == 503) << answer.body;
        seen.clear();
        if (answer.status != 200) continue;
        const auto json = nlohmann::json::parse(answer.body);
        for (const auto& model : json["models"]) seen.insert(model["name"].get<std::string>());
        if (seen != expected) std::this_thread::sleep_for(10ms);
    }
    EXPECT_EQ(seen, expected) << answer.body;
}

TEST_F(TwoPrograms, AnIndexThatIsMovedIntoPlaceIsServedAndWritten) {
    const fs::path new_index = folder_.path() / "made-elsewhere.index";
    const auto made = run_ossuary({"index", "--index", new_index.string(), "--resolution", "32",
                                   write_model("other").string()},
                                  folder_.path());
    ASSERT_EQ(made.exit_status, 0) << made.err;
    const TestServer server(index_, with_key());
    const RawAnswer before =
        server.ask(post("/v1/models?name=before", built_models()[0].off + "# before\n", bearer()));
    ASSERT_EQ(before.status, 202) << before.body;
    while (!finished(server, before.header("Location"))) std::this_thread::sleep_for(10ms);

    fs::rename(new_index, index_);
    expect_to_see(server, {"other"});
    EXPECT_EQ(server.ask(get("/readyz")).status, 200);
    const RawAnswer after =
        server.ask(post("/v1/models?name=after", built_models()[0].off + "# after\n", bearer()));
    ASSERT_EQ(after.status, 202) << after.body;
    while (!finished(server, after.header("Location"))) std::this_thread::sleep_for(10ms);
    expect_to_see(server, {"after", "other"});
    // What was written stands in the file of that name, and no other log has touched it.
    EXPECT_EQ(names(run({"models", "--json"}).json()["models"]),
              (std::set<std::string>{"after", "other"}));
    EXPECT_EQ(run({"verify"}).exit_status, 0);
}

TEST_F(TwoPrograms, AnIndexThatHasGoneTakesNothing) {
    const TestServer server(index_, with_key());
    EXPECT_EQ(server.ask(get("/readyz")).status, 200);
    fs::rename(index_, folder_.path() / "gone.index");
    const RawAnswer added =
        server.ask(post("/v1/models?name=lost", built_models()[0].off, bearer()));
    EXPECT_EQ(added.status, 503) << added.body;
    EXPECT_FALSE(added.header("Retry-After").empty());
    EXPECT_EQ(server.ask(get("/readyz")).status, 503);
    EXPECT_EQ(server.ask(get("/livez")).status, 200);
    EXPECT_FALSE(fs::exists(index_));
    fs::rename(folder_.path() / "gone.index", index_);
    expect_to_see(server, {"balla", "ballb", "ringa", "ringb", "treea", "treeb"});
    EXPECT_EQ(server.ask(get("/readyz")).status, 200);
}

}  // namespace
}  // namespace ossuary::test
