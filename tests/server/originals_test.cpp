// Where models lie, and what is made from their files.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "engine/core/whole_file.h"
#include "engine/mesh/read_mesh.h"
#include "index/store.h"
#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

class Originals : public testing::Test {
protected:
    Originals() {
        index_model(index_, "spare ring", built_models()[2].off + "# another file\n");
        index_model(index_, "spare tree", built_models()[4].off + "# another file\n");
    }
    fs::path file() const { return folder_.path() / "more-spare tree/spare tree.off"; }
    static std::string path(const std::string& part = {}) { return "/v1/models/8" + part; }
    static void serve(server::ServerOptions& options) { options.serve_files = true; }

    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
};

TEST_F(Originals, ArePlacedBelowTheIndexedFolders) {
    const TestServer server(index_);
    const std::string place = "more-spare tree/spare tree.off";
    const auto ends = [&](const nlohmann::json& told) {
        return told.get<std::string>().ends_with(place);
    };
    EXPECT_TRUE(ends(server.json(get(path()))["path"]));
    EXPECT_TRUE(ends(server.json(get("/v1/models?name=spare+tree"))["models"][0]["path"]));
    EXPECT_TRUE(ends(server.json(get("/v1/compare?a=1&b=8"))["b"]["path"]));
    EXPECT_TRUE(ends(server.json(get("/v1/models/5/similar?limit=1"))["hits"][0]["path"]));
    const nlohmann::json folders = server.json(get("/v1/facets?name=spare+tree"))["folders"];
    EXPECT_TRUE(ends(folders.back()["value"].get<std::string>() + "/spare tree.off"));
}

TEST_F(Originals, NoAnswerTellsWhereTheMachineKeepsThem) {
    const TestServer server(index_, serve);
    fs::remove(file());
    for (const char* each : {"/v1/models", "/v1/models/8", "/v1/models/99", "/v1/models/99/mesh",
                             "/v1/compare?a=1&b=8", "/v1/compare?a=1&b=99", "/v1/models/1/similar",
                             "/v1/models/99/similar", "/v1/facets", "/v1/models/8/file",
                             "/v1/models/8/mesh.stl", "/v1/models/8/rig.glb?detail=full"}) {
        EXPECT_EQ(server.ask(get(each)).body.find(folder_.path().string()), std::string::npos)
            << each;
    }
}

TEST_F(Originals, AreHadOnlyWhereTheServerIsTold) {
    const TestServer server(index_);
    for (const char* each : {"/file", "/mesh.stl", "/rig.glb?detail=full"}) {
        EXPECT_EQ(server.code(get(path(each)), 404), "original_not_available") << each;
    }
    EXPECT_FALSE(server.json(get(path()))["links"].contains("file"));
}

TEST_F(Originals, AreTheFilesThemselves) {
    const TestServer server(index_, serve);
    const nlohmann::json links = server.json(get(path()))["links"];
    const RawAnswer answer = server.ask(get(links["file"].get<std::string>()));
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(answer.body, read_whole_file(file())->view());
    EXPECT_EQ(answer.header("Content-Disposition"),
              "attachment; filename*=UTF-8''spare%20tree.off");
    const RawAnswer stl = server.ask(get(links["stl"].get<std::string>()));
    const auto read = mesh::read_mesh(stl.body, "x.stl");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->mesh.triangles.size(), mesh::read_mesh(file())->mesh.triangles.size());
}

TEST_F(Originals, AreRiggedAtTheirOwnResolution) {
    const TestServer server(index_, serve);
    const auto triangles = [&](const std::string& address) {
        const RawAnswer rig = server.ask(get(address));
        EXPECT_EQ(rig.status, 200) << address;
        const nlohmann::json gltf =
            nlohmann::json::parse(rig.body.substr(20, rig.body.find("BIN") - 24));
        std::size_t count = 0;
        for (const nlohmann::json& primitive : gltf["meshes"][0]["primitives"]) {
            count += gltf["accessors"][primitive["indices"].get<std::size_t>()]["count"]
                         .get<std::size_t>();
        }
        return count / 3;
    };
    const std::size_t whole = mesh::read_mesh(file())->mesh.triangles.size();
    EXPECT_EQ(triangles(path("/rig.glb?detail=full")), whole);
    EXPECT_EQ(server.code(get(path("/rig.glb?detail=fine")), 400), "parameter_invalid");
}

TEST_F(Originals, AreNotServedOnceTheyAreGoneOrOthers) {
    const TestServer server(index_, serve);
    std::ofstream(file(), std::ios::app) << "# changed\n";
    EXPECT_EQ(server.code(get(path("/file")), 404), "original_not_available");
    fs::remove(file());
    EXPECT_EQ(server.code(get(path("/file")), 404), "original_not_available");
    EXPECT_EQ(server.code(get("/v1/models/99/file"), 404), "model_not_found");
}

TEST_F(Originals, PicturesHaveAddressesThatNeverShowAnythingElse) {
    const TestServer server(index_);
    const std::string link = server.json(get(path()))["links"]["thumbnail"];
    EXPECT_EQ(server.json(get("/v1/models/5/similar?limit=1"))["hits"][0]["thumbnail"], link);
    const RawAnswer picture = server.ask(get(link));
    EXPECT_EQ(picture.header("Cache-Control"), "private, max-age=31536000, immutable");
    for (const char* other : {"/thumbnail.png", "/thumbnail.png?v=x"}) {
        const RawAnswer same = server.ask(get(path(other)));
        EXPECT_EQ(same.header("Cache-Control"), "no-cache") << other;
        EXPECT_EQ(same.body, picture.body) << other;
    }
    auto store = index::Store::open(index_, index::Access::kReadWrite);
    const auto was = store->model(8)->orientation.up;
    const std::vector<index::Change> turn = {index::TurnModel{
        8, {was == index::Up::kY ? index::Up::kZ : index::Up::kY, true}, std::nullopt}};
    ASSERT_TRUE(store->apply(turn));
    EXPECT_NE(server.json(get(path()))["links"]["thumbnail"], link);
    EXPECT_NE(server.json(get("/v1/models?name=spare+tree"))["models"][0]["links"]["thumbnail"],
              link);
}

TEST_F(Originals, CopiesAreFoldedOnRequest) {
    const TestServer server(index_);
    const nlohmann::json all =
        server.json(post("/v1/search?limit=2", built_models()[4].off))["hits"];
    EXPECT_EQ(all[0]["distance"], all[1]["distance"]);
    const nlohmann::json folded =
        server.json(post("/v1/search?limit=2&fold=true", built_models()[4].off))["hits"];
    ASSERT_EQ(folded.size(), 2u);
    EXPECT_EQ(folded[0]["id"], all[0]["id"]);
    EXPECT_EQ(folded[0]["copies"], 1);
    EXPECT_EQ(folded[1]["name"], "treeb");
    EXPECT_EQ(folded[1]["copies"], 0);
    EXPECT_EQ(server.json(get("/v1/models/5/similar?fold=true&limit=100"))["hits"].size(), 6u);
}

TEST_F(Originals, AreListedInOrderAndByWhatTheyAre) {
    const TestServer server(index_);
    const auto names = [&](const std::string& query) {
        std::string list;
        const nlohmann::json page = server.json(get("/v1/models?" + query));
        for (const nlohmann::json& each : page["models"])
            list += each["name"].get<std::string>() + ' ';
        return list;
    };
    const nlohmann::json folder =
        server.json(get("/v1/facets?name=spare+ring"))["folders"].back()["value"];
    std::string escaped = folder.get<std::string>();
    std::replace(escaped.begin(), escaped.end(), ' ', '+');
    EXPECT_EQ(names("sort=name&offset=5&limit=2"), "spare tree treea ");
    EXPECT_EQ(names("sort=name&offset=99"), "");
    EXPECT_EQ(names("folder=" + escaped), "spare ring ");
    EXPECT_EQ(names("kind=stl"), "");
    const nlohmann::json page = server.json(get("/v1/models?sort=name&limit=2"));
    EXPECT_TRUE(page["next_cursor"].is_null()) << "offsets lead on, no cursor";
    EXPECT_EQ(page["total"], 8);
    const nlohmann::json facets = server.json(get("/v1/facets?name=tree&include=loops"));
    EXPECT_EQ(facets["classes"], nlohmann::json::parse(R"([{"value":null,"models":1},
                                                 {"value":"tree","models":2}])"));
    EXPECT_EQ(facets["kinds"], nlohmann::json::parse(R"([{"value":"off","models":3}])"));
    // Built in code: files that name no unit.
    EXPECT_EQ(facets["units"], nlohmann::json::parse(R"([{"value":null,"models":3}])"));
    EXPECT_EQ(facets["loops"], nlohmann::json::parse(R"([{"value":"0","models":3}])"));
    EXPECT_FALSE(server.json(get("/v1/facets")).contains("loops"));
    const nlohmann::json rings = server.json(get("/v1/facets?name=ring&include=loops"));
    EXPECT_EQ(rings["loops"][0]["value"], "1");
    for (const char* facet : {"branches", "loops", "extents"}) {
        ASSERT_FALSE(facets[facet].empty()) << facet;
        const std::string parameter = facet == std::string_view("extents") ? "extent" : facet;
        for (const auto& [value, models] : facets[facet].items()) {
            const std::string url =
                "/v1/models?name=tree&" + parameter + "=" + models["value"].get<std::string>();
            EXPECT_EQ(server.json(get(url))["total"], models["models"]) << url;
        }
    }
    for (const char* bad : {"branches=5", "loops=x", "extent=1-2", "unit="}) {
        EXPECT_EQ(server.code(get(std::string("/v1/facets?") + bad), 400), "parameter_invalid");
    }
    const std::string cursor = server.json(get("/v1/models?limit=1"))["next_cursor"];
    for (const char* with : {"&sort=name", "&offset=1", "&kind=off", "&loops=0"}) {
        EXPECT_EQ(server.code(get("/v1/models?cursor=" + cursor + with), 400), "parameter_invalid");
    }
}

}  // namespace
}  // namespace ossuary::test
