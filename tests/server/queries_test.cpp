#include "server/queries.h"

#include <gtest/gtest.h>

#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

using server::Queries;

std::shared_ptr<index::QueryModel> model_of(std::size_t triangles) {
    mesh::TriangleMesh mesh;
    mesh.vertices = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
    mesh.triangles.assign(triangles, {0, 1, 2});
    return std::make_shared<index::QueryModel>("x", mesh, std::vector<mesh::MeshWarning>(),
                                               index::FileFrame{}, index::DescribedQuery{});
}

/// Time that passes only when told.
struct Watch {
    Queries::Clock::time_point now{};
    std::function<Queries::Clock::time_point()> asked() {
        return [this] { return now; };
    }
};

TEST(Queries, KeepsEachUnderATokenOfItsOwn) {
    Queries queries({});
    const auto model = model_of(1);
    const std::string token = queries.keep(model);
    EXPECT_EQ(token.size(), 32u);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_NE(queries.keep(model), token);
    EXPECT_EQ(queries.find(token), model);
    EXPECT_EQ(queries.find("0123456789abcdef0123456789abcdef"), nullptr);
    EXPECT_EQ(queries.find(""), nullptr);
}

TEST(Queries, ForgetsWhatNobodyHasAskedForInAQuarterOfAnHour) {
    using namespace std::chrono_literals;
    Watch watch;
    Queries queries({}, watch.asked());
    const std::string used = queries.keep(model_of(1));
    const std::string left = queries.keep(model_of(1));
    watch.now += 14min;
    EXPECT_NE(queries.find(used), nullptr);
    watch.now += 2min;
    EXPECT_EQ(queries.find(left), nullptr);
    EXPECT_NE(queries.find(used), nullptr);
    watch.now += 16min;
    EXPECT_EQ(queries.find(used), nullptr);
}

TEST(Queries, MakesRoomByTheLeastRecentlyUsed) {
    using namespace std::chrono_literals;
    Watch watch;
    const std::size_t one = model_of(1000)->bytes();
    Queries queries({.bytes = 2 * one}, watch.asked());
    const std::string first = queries.keep(model_of(1000));
    watch.now += 1s;
    const std::string second = queries.keep(model_of(1000));
    watch.now += 1s;
    EXPECT_NE(queries.find(first), nullptr);
    watch.now += 1s;
    const std::string third = queries.keep(model_of(1000));
    EXPECT_NE(queries.find(first), nullptr);
    EXPECT_EQ(queries.find(second), nullptr);
    EXPECT_NE(queries.find(third), nullptr);
    EXPECT_EQ(queries.keep(model_of(1'000'000)), "") << "larger than all room";
    EXPECT_NE(queries.find(third), nullptr);
}

TEST(Queries, KeepsNoMoreThanSoMany) {
    Queries queries({.count = 2});
    const std::string first = queries.keep(model_of(1));
    queries.keep(model_of(1));
    queries.keep(model_of(1));
    EXPECT_EQ(queries.find(first), nullptr);
}

class KeptQueries : public testing::Test {
protected:
    TemporaryFolder folder_;
    std::filesystem::path index_ = copy_of_built_index(folder_.path());
    TestServer server_{index_};
    static const std::string& tree() { return built_models()[4].off; }
};

/// Without what tells times, and without the preview, which a kept upload has at its own address.
nlohmann::json without_times(nlohmann::json answer) {
    answer.erase("took_ms");
    answer.erase("stages_ms");
    answer["query"].erase("mesh");
    return answer;
}

TEST_F(KeptQueries, AnswerAsTheUploadDid) {
    for (const std::string options :
         {"?limit=3", "?limit=3&ranker=skeleton&pose=0.5", "?limit=3&part=true", "?rerank=true"}) {
        const nlohmann::json sent =
            server_.json(post("/v1/search" + options + "&include=mesh", tree()));
        const std::string token = sent["token"];
        const std::string path = "/v1/queries/" + token;
        EXPECT_EQ(without_times(server_.json(get(path + "/similar" + options))),
                  without_times(sent))
            << options;
    }
}

TEST_F(KeptQueries, HaveWhatIndexedModelsHave) {
    const nlohmann::json sent = server_.json(post("/v1/search?name=oak&include=mesh", tree()));
    const nlohmann::json query =
        server_.json(get("/v1/queries/" + sent["token"].get<std::string>()));
    EXPECT_EQ(query["name"], "oak");
    EXPECT_EQ(query["faces"], sent["query"]["faces"]);
    EXPECT_EQ(server_.json(get(query["links"]["mesh"].get<std::string>())), sent["query"]["mesh"]);
    EXPECT_EQ(server_.json(get(query["links"]["skeleton"].get<std::string>())),
              sent["query"]["skeleton"]);
    // The same file was indexed as model 5.
    EXPECT_EQ(server_.json(get(query["links"]["segments"].get<std::string>())),
              server_.json(get("/v1/models/5/segments")));
    for (const char* rig : {"/rig.glb", "/rig.glb?detail=full"}) {
        const RawAnswer answer =
            server_.ask(get("/v1/queries/" + query["token"].get<std::string>() + rig));
        EXPECT_EQ(answer.status, 200) << rig;
        EXPECT_EQ(answer.body.substr(0, 4), "glTF") << rig;
    }
    const RawAnswer stl = server_.ask(get(query["links"]["stl"].get<std::string>()));
    EXPECT_EQ(stl.header("Content-Type"), "model/stl");
    EXPECT_EQ(stl.header("Content-Disposition"), "attachment; filename*=UTF-8''oak.stl");
    EXPECT_GT(stl.body.size(), 84 + 50 * query["faces"].get<std::size_t>() - 1);
}

TEST_F(KeptQueries, FollowTheCollection) {
    const nlohmann::json sent = server_.json(post("/v1/search", tree()));
    const std::string path = "/v1/queries/" + sent["token"].get<std::string>() + "/similar";
    const RawAnswer first = server_.ask(get(path));
    EXPECT_EQ(server_.ask(get(path, "If-None-Match: " + first.header("ETag") + "\r\n")).status,
              304);
    index_model(index_, "newcomer", built_models()[2].off + "# another file\n");
    EXPECT_EQ(server_.json(get(path, "If-None-Match: " + first.header("ETag") + "\r\n"))["models"],
              7);
}

TEST_F(KeptQueries, SayWhenTheyAreGone) {
    const std::string path = "/v1/queries/0123456789abcdef0123456789abcdef";
    for (const char* part : {"", "/similar", "/mesh", "/skeleton", "/segments", "/rig.glb",
                             "/mesh.stl", "/rig.glb?detail=full"}) {
        EXPECT_EQ(server_.code(get(path + part), 404), "query_not_found") << part;
    }
    const TestServer forgetful(
        index_, [](server::ServerOptions& options) { options.kept_queries_bytes = 0; });
    const nlohmann::json sent = forgetful.json(post("/v1/search?include=mesh", tree()));
    EXPECT_TRUE(sent["token"].is_null());
    EXPECT_FALSE(sent["query"]["mesh"]["triangles"].empty());
}

}  // namespace
}  // namespace ossuary::test
