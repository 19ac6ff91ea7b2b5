#include <gtest/gtest.h>

#include <set>

#include "engine/mesh/write_mesh.h"
#include "index/describe_model.h"
#include "index/store.h"
#include "tests/server/test_server.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

class Models : public testing::Test {
protected:
    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
    TestServer server_{index_};
};

TEST_F(Models, ListsAllOnOnePage) {
    const auto page = server_.json(get("/v1/models"));
    EXPECT_EQ(page["total"], 6);
    ASSERT_EQ(page["models"].size(), 6u);
    EXPECT_TRUE(page["next_cursor"].is_null());
    EXPECT_GE(page["revision"], 1);
    const auto& model = page["models"][0];
    for (const char* key :
         {"id", "name", "class", "path", "content_hash", "vertices", "faces", "nodes", "branches",
          "bounds", "surface_area", "indexed_at", "warnings", "links"}) {
        EXPECT_TRUE(model.contains(key)) << key;
    }
}

TEST_F(Models, PagesWithoutGapsOrRepeats) {
    std::vector<std::int64_t> ids;
    std::string cursor;
    int pages = 0;
    do {
        const auto page =
            server_.json(get("/v1/models?limit=4" + (cursor.empty() ? "" : "&cursor=" + cursor)));
        for (const auto& model : page["models"]) ids.push_back(model["id"]);
        EXPECT_EQ(page["total"], 6);
        cursor = page["next_cursor"].is_null() ? "" : page["next_cursor"].get<std::string>();
        ++pages;
    } while (!cursor.empty() && pages < 10);
    EXPECT_EQ(pages, 2);
    EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
    EXPECT_EQ(std::set<std::int64_t>(ids.begin(), ids.end()).size(), 6u);
}

TEST_F(Models, RefusesCursorsThatItDidNotGive) {
    const std::string cursor = server_.json(get("/v1/models?limit=1"))["next_cursor"];
    EXPECT_EQ(server_.ask(get("/v1/models?limit=1&cursor=" + cursor)).status, 200);
    for (const std::string& bad : {std::string("x"), std::string("00000000"), cursor + "g",
                                   "0" + cursor, cursor + "&class=ring", std::string("%ff")}) {
        const auto json = server_.json(get("/v1/models?cursor=" + bad), 400);
        EXPECT_TRUE(json.value("parameter", "") == "cursor" || json["code"] == "bad_escape") << bad;
    }
}

TEST_F(Models, FiltersByClassAndName) {
    EXPECT_EQ(server_.json(get("/v1/models?class=tree"))["total"], 2);
    EXPECT_EQ(server_.json(get("/v1/models?name=RING"))["total"], 2);
    EXPECT_EQ(server_.json(get("/v1/models?name=a&class=ball"))["total"], 2);
    EXPECT_EQ(server_.json(get("/v1/models?name=%25"))["total"], 0);
    EXPECT_EQ(server_.json(get("/v1/models?name='+OR+1=1+--"))["total"], 0);
}

TEST_F(Models, GivesEachModelWithItsParts) {
    const auto all = server_.json(get("/v1/models"));
    for (const auto& listed : all["models"]) {
        const std::string path = "/v1/models/" + std::to_string(listed["id"].get<int>());
        EXPECT_EQ(server_.json(get(path)), listed);
        const auto mesh = server_.json(get(listed["links"]["mesh"].get<std::string>()));
        EXPECT_FALSE(mesh["triangles"].empty());
        EXPECT_EQ(mesh["bounds"], listed["bounds"]);
        const auto skeleton = server_.json(get(listed["links"]["skeleton"].get<std::string>()));
        EXPECT_EQ(skeleton["nodes"].size(), listed["nodes"]);
        EXPECT_EQ(skeleton["branches"].size(), listed["branches"]);
        for (const auto& branch : skeleton["branches"]) EXPECT_TRUE(branch.contains("chain_code"));
        const auto picture = server_.ask(get(listed["links"]["thumbnail"].get<std::string>()));
        EXPECT_EQ(picture.status, 200);
        EXPECT_EQ(picture.header("Content-Type"), "image/png");
        EXPECT_EQ(picture.body.substr(1, 3), "PNG");
        const auto segments = server_.json(get(path + "/segments"));
        EXPECT_EQ(segments["labels"].size() * 3, mesh["triangles"].size());
        std::size_t triangles = 0;
        double area = 0.0;
        for (const auto& part : segments["parts"]) {
            triangles += part["triangles"].get<std::size_t>();
            area += part["area"].get<double>();
            if (!part["branch"].is_null()) {
                EXPECT_LT(part["branch"].get<std::size_t>(), skeleton["branches"].size());
            }
        }
        EXPECT_EQ(triangles, segments["labels"].size());
        const double surface = listed["surface_area"].get<double>();
        EXPECT_NEAR(area, surface, 1e-9 * surface) << "of the whole mesh, not of its preview";
        const auto rig = server_.ask(get(path + "/rig.glb"));
        EXPECT_EQ(rig.status, 200);
        EXPECT_EQ(rig.header("Content-Type"), "model/gltf-binary");
        ASSERT_GT(rig.body.size(), 20U);
        EXPECT_EQ(rig.body.substr(0, 4), "glTF");
        const auto gltf = nlohmann::json::parse(rig.body.substr(20, rig.body.find("BIN") - 24));
        EXPECT_EQ(gltf["meshes"][0]["primitives"].size(), segments["parts"].size());
        EXPECT_GT(gltf["skins"][0]["joints"].size(), skeleton["branches"].size());
    }
}

TEST_F(Models, SaysWhyAModelHasNoParts) {
    auto store = index::Store::open(index_, index::Access::kReadWrite);
    ASSERT_TRUE(store);
    const std::string off = mesh::to_off(torus_mesh(3.0, 1.0, 16, 8));
    auto model = index::describe_model({off, "whole"}, store->parameters());
    ASSERT_TRUE(model && model->segments);
    model->summary.name = "whole";
    model->segments.reset();
    model->summary.warnings.push_back(
        {std::string(index::kSegmentsMissing), 1, "it took too long"});
    const auto id = store->put(*std::move(model));
    ASSERT_TRUE(id) << id.error().message;
    const std::string path = "/v1/models/" + std::to_string(*id);
    for (const char* part : {"/segments", "/rig.glb"}) {
        const auto problem = server_.json(get(path + part), 404);
        EXPECT_EQ(problem["code"], "segments_not_available");
        EXPECT_NE(problem["detail"].get<std::string>().find("it took too long"), std::string::npos);
    }
    EXPECT_EQ(server_.ask(get(path + "/mesh")).status, 200);
}

TEST_F(Models, SaysWhichModelsThereAreNot) {
    for (const char* part :
         {"", "/mesh", "/skeleton", "/thumbnail.png", "/segments", "/rig.glb", "/similar"}) {
        const std::string path = "/v1/models/999" + std::string(part);
        EXPECT_EQ(server_.code(get(path), 404), "model_not_found") << path;
    }
    for (const char* id : {"0", "-1", "x", "1x", "99999999999999999999"}) {
        EXPECT_EQ(server_.code(get("/v1/models/" + std::string(id)), 400), "parameter_invalid")
            << id;
    }
    EXPECT_EQ(server_.code(get("/v1/models/1?x=1"), 400), "parameter_unknown");
    EXPECT_EQ(server_.code(get("/v1/models/1/feet"), 404), "route_not_found");
}

TEST_F(Models, AnswersNotModifiedWhileNothingHasChanged) {
    for (const char* path :
         {"/v1/models", "/v1/models/1", "/v1/models/1/mesh", "/v1/models/1/skeleton",
          "/v1/models/1/segments", "/v1/models/1/rig.glb", "/v1/models/1/thumbnail.png",
          "/v1/models/1/similar?limit=2", "/v1/compare?a=1&b=2", "/openapi.yaml"}) {
        const RawAnswer first = server_.ask(get(path));
        ASSERT_EQ(first.status, 200) << path;
        const std::string etag = first.header("ETag");
        ASSERT_FALSE(etag.empty()) << path;
        const RawAnswer second = server_.ask(get(path, "If-None-Match: " + etag + "\r\n"));
        EXPECT_EQ(second.status, 304) << path;
        EXPECT_TRUE(second.body.empty()) << path;
        EXPECT_EQ(second.header("ETag"), etag) << path;
        EXPECT_EQ(server_.ask(get(path, "If-None-Match: \"x\", " + etag + "\r\n")).status, 304);
        EXPECT_EQ(server_.ask(get(path, "If-None-Match: *\r\n")).status, 304) << path;
        EXPECT_EQ(server_.ask(get(path, "If-None-Match: \"x\"\r\n")).status, 200) << path;
    }
}

TEST_F(Models, ForgetsATagWhenTheCollectionChanges) {
    const std::string list = server_.ask(get("/v1/models")).header("ETag");
    const std::string similar = server_.ask(get("/v1/models/1/similar")).header("ETag");
    index_model(index_, "newcomer", built_models()[2].off + "# another file\n");
    EXPECT_EQ(server_.ask(get("/v1/models", "If-None-Match: " + list + "\r\n")).status, 200);
    EXPECT_EQ(server_.ask(get("/v1/models/1/similar", "If-None-Match: " + similar + "\r\n")).status,
              200);
    EXPECT_EQ(server_.json(get("/v1/models"))["total"], 7);
}

TEST_F(Models, RanksTheOthersAroundOne) {
    const auto models = server_.json(get("/v1/models"))["models"];
    for (const auto& model : models) {
        const auto json = server_.json(get(model["links"]["similar"].get<std::string>()));
        EXPECT_EQ(json["hits"].size(), 5u);
        for (const auto& hit : json["hits"]) EXPECT_NE(hit["id"], model["id"]);
        EXPECT_EQ(json["query"]["name"], model["name"]);
    }
    EXPECT_EQ(server_.json(get("/v1/models/1/similar?limit=2&class=tree"))["hits"].size(), 2u);
}

TEST_F(Models, ComparesTwo) {
    const auto there = server_.json(get("/v1/compare?a=5&b=6"));
    const auto back = server_.json(get("/v1/compare?a=6&b=5"));
    EXPECT_NEAR(there["distance"].get<double>(), back["distance"].get<double>(), 1e-9);
    EXPECT_EQ(there["a"]["name"], "treea");
    EXPECT_EQ(there["b"]["name"], "treeb");
    EXPECT_EQ(there["a"], server_.json(get("/v1/models/5")));
    EXPECT_GT(there["matched_nodes"], 0);
    for (const auto& pair : there["match"]["branches"]) {
        EXPECT_LT(pair["a"], there["skeletons"]["a"]["branches"].size());
        EXPECT_LT(pair["b"], there["skeletons"]["b"]["branches"].size());
    }
    EXPECT_NEAR(server_.json(get("/v1/compare?a=5&b=5"))["distance"].get<double>(), 0.0, 1e-9);
    EXPECT_EQ(server_.code(get("/v1/compare?a=5"), 400), "parameter_missing");
    EXPECT_EQ(server_.code(get("/v1/compare?a=5&b=x"), 400), "parameter_invalid");
    EXPECT_EQ(server_.code(get("/v1/compare?a=5&b=99"), 404), "model_not_found");
}

TEST_F(Models, EvaluatesTheCollectionOnceAndServesItInThreeForms) {
    auto list = server_.json(get("/v1/evaluations"))["evaluations"];
    ASSERT_EQ(list.size(), 3u);
    for (const auto& entry : list) EXPECT_TRUE(entry["computed_at"].is_null());

    const auto json = server_.json(get("/v1/evaluations/hybrid"));
    EXPECT_EQ(json["models"], 6);
    EXPECT_EQ(json["classes"], 3);
    EXPECT_EQ(json["ranker"], "hybrid");
    EXPECT_EQ(json["precision_recall"].size(), 20u);
    EXPECT_EQ(json["per_class"].size(), 3u);
    EXPECT_GE(json["nearest_neighbor"], 0.0);
    EXPECT_LE(json["nearest_neighbor"], 1.0);

    const RawAnswer csv = server_.ask(get("/v1/evaluations/hybrid.csv"));
    EXPECT_EQ(csv.header("Content-Type"), "text/csv; charset=utf-8");
    EXPECT_EQ(std::count(csv.body.begin(), csv.body.end(), '\n'), 21);
    const RawAnswer svg = server_.ask(get("/v1/evaluations/hybrid.svg"));
    EXPECT_EQ(svg.header("Content-Type"), "image/svg+xml");
    EXPECT_NE(svg.body.find("<svg"), std::string::npos);

    list = server_.json(get("/v1/evaluations"))["evaluations"];
    for (const auto& entry : list) {
        EXPECT_EQ(entry["computed_at"].is_null(), entry["ranker"] != "hybrid");
    }
    EXPECT_EQ(server_.json(get("/v1/evaluations/hybrid?rerank=true"))["rerank"], true);
    EXPECT_EQ(server_.code(get("/v1/evaluations/best"), 400), "parameter_invalid");
    EXPECT_EQ(server_.code(get("/v1/evaluations/hybrid.pdf"), 400), "parameter_invalid");
}

TEST_F(Models, TellsTheMeasuresOfEachQueryAndWhereTheyWouldLieForOthers) {
    const auto json = server_.json(get("/v1/evaluations/hybrid?include=queries"));
    ASSERT_EQ(json["queries"].size(), 6u);
    double sum = 0.0;
    for (const auto& query : json["queries"]) {
        const auto model =
            server_.json(get("/v1/models/" + std::to_string(query["model"].get<int>())));
        EXPECT_EQ(query["name"], model["name"]);
        EXPECT_EQ(query["class"], model["class"]);
        sum += query["dcg"].get<double>();
    }
    EXPECT_NEAR(json["dcg"].get<double>(), sum / 6.0, 1e-12);
    EXPECT_LE(json["intervals"]["dcg"]["low"], json["dcg"]);
    EXPECT_GE(json["intervals"]["dcg"]["high"], json["dcg"]);
    EXPECT_EQ(json["queries_total"], 6);
    EXPECT_FALSE(server_.json(get("/v1/evaluations/hybrid")).contains("queries"));
    EXPECT_EQ(server_.code(get("/v1/evaluations/hybrid?include=all"), 400), "parameter_invalid");
}

TEST_F(Models, LooksOnlyAmongTheFilesThatAreAskedFor) {
    const auto all = server_.json(get("/v1/models/1/similar?limit=10"))["hits"];
    EXPECT_EQ(server_.json(get("/v1/models/1/similar?limit=10&kind=off"))["hits"].size(),
              all.size());
    EXPECT_TRUE(server_.json(get("/v1/models/1/similar?kind=stl"))["hits"].empty());
    EXPECT_TRUE(server_.json(get("/v1/models/1/similar?folder=elsewhere"))["hits"].empty());
}

}  // namespace
}  // namespace ossuary::test
