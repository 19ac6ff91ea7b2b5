// server/openapi.yaml says what the server does: routes, parameters, codes and the shape of every
// answer are held against the running server.

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "server/problem.h"
#include "server/router.h"
#include "tests/server/contract.h"
#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

TEST(Yaml, ReadsWhatTheContractIsWrittenIn) {
    const nlohmann::json read = parse_yaml(
        "a: 1\nb:\n  - x\n  - k: 'v: w'\n    l: [p, 2.5, 'null',\n        q]\nc: |\n  one\n\n  "
        "two\n"
        "d: &n\n  '200': { e: true, f: null }\ng: *n\nh: \"# not a comment\"\n");
    EXPECT_EQ(read, nlohmann::json::parse(R"({"a":1,"b":["x",{"k":"v: w","l":["p",2.5,"null","q"]}],
        "c":"one\n\ntwo\n","d":{"200":{"e":true,"f":null}},"g":{"200":{"e":true,"f":null}},
        "h":"# not a comment"})"));
    EXPECT_ANY_THROW(parse_yaml("a: 1\n  b: 2\n"));
}

TEST(Contract, ValidationFindsFaults) {
    const nlohmann::json schema = {{"type", "object"},
                                   {"required", {"n"}},
                                   {"properties", {{"n", {{"type", "integer"}, {"minimum", 1}}}}}};
    const auto fits = [](const nlohmann::json& each, const nlohmann::json& value) {
        return schema_faults(each, value).empty();
    };
    EXPECT_TRUE(fits(schema, {{"n", 1}}));
    EXPECT_FALSE(fits(schema, {{"n", 0}}));
    EXPECT_FALSE(fits(schema, {{"n", "1"}}));
    EXPECT_FALSE(fits(schema, nlohmann::json::object()));
    EXPECT_FALSE(fits(schema, {{"n", 1}, {"m", 1}}));
    EXPECT_FALSE(fits(schema, nlohmann::json::array()));
    const nlohmann::json open = {{"type", "object"},
                                 {"additionalProperties", {{"type", "number"}}}};
    EXPECT_TRUE(fits(open, {{"any", 1.5}}));
    EXPECT_FALSE(fits(open, {{"any", "text"}}));
    const nlohmann::json both = {{"allOf", {schema}},
                                 {"properties", {{"m", {{"type", {"null", "string"}}}}}}};
    EXPECT_TRUE(fits(both, {{"n", 1}, {"m", nullptr}}));
    EXPECT_FALSE(fits(both, {{"m", "x"}}));
    EXPECT_FALSE(fits(both, {{"n", 1}, {"o", 1}}));
    // References of the contract are followed, and what they lead to is closed as well.
    const nlohmann::json vector = {{"type", "array"},
                                   {"items", {{"$ref", "#/components/schemas/Bounds"}}}};
    const nlohmann::json bounds = {{"min", {0, 0, 0}}, {"max", {1, 1, 1}}};
    EXPECT_TRUE(fits(vector, nlohmann::json::array({bounds})));
    nlohmann::json odd = bounds;
    odd["middle"] = {0, 0, 0};
    EXPECT_FALSE(fits(vector, nlohmann::json::array({odd})));
    odd = bounds;
    odd["max"] = {1, 1};
    EXPECT_FALSE(fits(vector, nlohmann::json::array({odd})));
}

TEST(Contract, NamesEveryRouteAndNoOther) {
    std::set<std::string> described;
    for (const auto& [path, item] : contract().at("paths").items()) {
        if (path == "/{file}") continue;
        for (const char* method : {"get", "post", "put", "delete", "patch"}) {
            if (item.contains(method)) described.insert(std::string(method) + " " + path);
        }
    }
    std::set<std::string> served;
    for (const server::Route& route : server::routes()) {
        std::string method(route.method);
        for (char& c : method) c = static_cast<char>(std::tolower(c));
        served.insert(method + " " + std::string(route.pattern));
    }
    EXPECT_EQ(described, served);
}

TEST(Contract, NamesEveryProblemCodeAndNoOther) {
    std::set<std::string> described;
    for (const nlohmann::json& code :
         contract().at("/components/schemas/ProblemCode/enum"_json_pointer)) {
        EXPECT_TRUE(described.insert(code).second) << code << " is there twice";
    }
    std::set<std::string> known;
    for (const server::ProblemRow& row : server::problem_table()) known.emplace(row.code);
    EXPECT_EQ(described, known);
}

TEST(Contract, EveryReferenceLeadsSomewhere) {
    int references = 0;
    const std::function<void(const nlohmann::json&)> walk = [&](const nlohmann::json& node) {
        if (node.is_object() && node.contains("$ref")) {
            ++references;
            EXPECT_NO_THROW((void)resolved(node)) << node;
        }
        if (node.is_structured()) {
            for (const nlohmann::json& child : node) walk(child);
        }
    };
    walk(contract());
    EXPECT_GT(references, 100);
}

TEST(Contract, ProtectsTheAdministratorsRoutes) {
    for (const server::Route& route : server::routes()) {
        std::string method(route.method);
        for (char& c : method) c = static_cast<char>(std::tolower(c));
        const nlohmann::json& operation = contract()["paths"][std::string(route.pattern)][method];
        // Unless an operation says otherwise, it is for readers.
        nlohmann::json needed;
        if (route.audience == server::Audience::kAdministrator) {
            needed = {{{"adminKey", nlohmann::json::array()}}};
        } else if (route.pattern == "/livez" || route.pattern == "/readyz") {
            needed = nlohmann::json::array();
        }
        EXPECT_EQ(operation.value("security", nlohmann::json()), needed) << route.pattern;
        EXPECT_EQ(operation.contains("requestBody"), route.body == server::Body::kModel)
            << route.pattern;
    }
}

class RunningContract : public testing::Test {
protected:
    TemporaryFolder folder_;
    std::filesystem::path index_ = copy_of_built_index(folder_.path());
    TestServer server_{index_};

    /// Holds an answer against what the contract says of this operation.
    void hold(const std::string& method, const std::string& path, std::string_view bytes,
              int status) {
        const RawAnswer answer = server_.ask(bytes);
        ASSERT_EQ(answer.status, status) << bytes.substr(0, 80) << answer.body.substr(0, 300);
        const nlohmann::json& operation = contract().at("paths").at(path).at(method);
        ASSERT_TRUE(operation["responses"].contains(std::to_string(status)))
            << path << " does not mention " << status;
        const nlohmann::json& response = resolved(operation["responses"][std::to_string(status)]);
        const auto headers = response.value("headers", nlohmann::json::object());
        for (const auto& [name, ignored] : headers.items()) {
            EXPECT_FALSE(answer.header(name).empty()) << path << " lacks " << name;
        }
        const std::string type = answer.header("Content-Type");
        const std::string media = type.substr(0, type.find(';'));
        const nlohmann::json content = response.value("content", nlohmann::json::object());
        if (media.empty()) {
            EXPECT_TRUE(content.empty()) << path;
            return;
        }
        ASSERT_TRUE(content.contains(media)) << path << " does not mention " << media;
        if (media.find("json") == std::string::npos) return;
        for (const auto& fault :
             schema_faults(content[media]["schema"], nlohmann::json::parse(answer.body)))
            ADD_FAILURE() << path << fault;
    }
};

TEST_F(RunningContract, HoldsForEveryKindOfAnswer) {
    const std::string& tree = built_models()[4].off;
    const std::string models = "/v1/models";
    for (const char* ranker : {"hybrid", "skeleton", "chain-code"}) {
        hold("post", "/v1/search",
             post("/v1/search?include=mesh&ranker=" + std::string(ranker), tree), 200);
        hold("get", "/v1/compare", get("/v1/compare?a=1&b=5&ranker=" + std::string(ranker)), 200);
        hold("get", "/v1/evaluations/{ranker}", get("/v1/evaluations/" + std::string(ranker)), 200);
    }
    hold("post", "/v1/search", post("/v1/search?limit=x", tree), 400);
    hold("post", "/v1/search", post("/v1/search", tree, "Sec-Fetch-Site: cross-site\r\n"), 403);
    hold("post", "/v1/search", test::request("POST", "/v1/search"), 411);
    hold("post", "/v1/search", post("/v1/search", "OFF\n4000000000 1 0\n"), 413);
    hold("post", "/v1/search", post("/v1/search", "no model"), 415);
    hold("post", "/v1/search", post("/v1/search", "OFF\n3 1 0\n"), 422);
    hold("get", models, get(models + "?limit=2"), 200);
    hold("get", models, get(models + "?cursor=x"), 400);
    hold("post", models, post(models, tree), 403);
    hold("get", models + "/{id}", get(models + "/1"), 200);
    hold("get", models + "/{id}", get(models + "/1", "If-None-Match: *\r\n"), 304);
    hold("get", models + "/{id}", get(models + "/x"), 400);
    hold("get", models + "/{id}", get(models + "/99"), 404);
    hold("patch", models + "/{id}", test::request("PATCH", models + "/1?up=z"), 403);
    hold("delete", models + "/{id}", test::request("DELETE", models + "/1"), 403);
    hold("get", models + "/{id}/similar", get(models + "/1/similar"), 200);
    hold("get", models + "/{id}/similar", get(models + "/99/similar"), 404);
    hold("get", models + "/{id}/mesh", get(models + "/1/mesh"), 200);
    hold("get", models + "/{id}/skeleton", get(models + "/5/skeleton"), 200);
    hold("get", models + "/{id}/segments", get(models + "/5/segments"), 200);
    hold("get", models + "/{id}/segments", get(models + "/99/segments"), 404);
    hold("get", models + "/{id}/rig.glb", get(models + "/5/rig.glb"), 200);
    hold("get", models + "/{id}/rig.glb", get(models + "/5/rig.glb", "If-None-Match: *\r\n"), 304);
    hold("get", models + "/{id}/rig.glb", get(models + "/99/rig.glb"), 404);
    hold("get", models + "/{id}/thumbnail.png", get(models + "/5/thumbnail.png"), 200);
    hold("get", models + "/{id}/thumbnail.png", get(models + "/5/thumbnail.png?v=1"), 200);
    hold("get", models + "/{id}/file", get(models + "/5/file"), 404);
    hold("get", models + "/{id}/mesh.stl", get(models + "/5/mesh.stl"), 404);
    hold("get", "/v1/facets", get("/v1/facets"), 200);
    const std::string token = server_.json(post("/v1/search", tree))["token"];
    const std::string query = "/v1/queries/{token}";
    for (const char* part :
         {"", "/similar", "/mesh", "/skeleton", "/segments", "/rig.glb", "/mesh.stl"}) {
        hold("get", query + part, get("/v1/queries/" + token + part), 200);
        hold("get", query + part, get("/v1/queries/x" + std::string(part)), 404);
    }
    hold("get", "/v1/compare", get("/v1/compare?a=1"), 400);
    hold("get", "/v1/evaluations", get("/v1/evaluations"), 200);
    hold("get", "/v1/evaluations/{ranker}.csv", get("/v1/evaluations/hybrid.csv"), 200);
    hold("get", "/v1/evaluations/{ranker}.svg", get("/v1/evaluations/hybrid.svg"), 200);
    hold("get", "/v1/evaluations/{ranker}", get("/v1/evaluations/best"), 400);
    hold("get", "/v1/progress/{token}", get("/v1/progress/" + token), 200);
    hold("get", "/v1/jobs", get("/v1/jobs"), 403);
    hold("get", "/v1/jobs/{id}", get("/v1/jobs/1"), 404);
    hold("get", "/livez", get("/livez"), 200);
    hold("get", "/readyz", get("/readyz"), 200);
    hold("get", "/metrics", get("/metrics"), 200);
    hold("get", "/openapi.yaml", get("/openapi.yaml"), 200);
    hold("get", "/openapi.yaml", get("/openapi.yaml", "If-None-Match: *\r\n"), 304);
}

TEST_F(RunningContract, TakesExactlyTheParametersThatItNames) {
    for (const auto& [path, item] : contract().at("paths").items()) {
        if (!item.contains("get") || path == "/{file}" || !path.starts_with("/v1")) continue;
        // Without a key none of its parameters is looked at.
        if (item["get"].contains("security")) continue;
        nlohmann::json parameters = item.value("parameters", nlohmann::json::array());
        for (const nlohmann::json& each :
             item["get"].value("parameters", nlohmann::json::array())) {
            parameters.push_back(each);
        }
        std::string address = std::regex_replace(path, std::regex("\\{id\\}"), "1");
        address = std::regex_replace(address, std::regex("\\{ranker\\}"), "hybrid");
        address = std::regex_replace(address, std::regex("\\{token\\}"), "x");
        std::set<std::string> names;
        for (const nlohmann::json& each : parameters) {
            if (resolved(each)["in"] == "query") names.insert(resolved(each)["name"]);
        }
        for (const char* name :
             {"a",      "b",      "limit",   "cursor",   "ranker", "pose",   "size",   "class",
              "rerank", "part",   "include", "name",     "fold",   "sort",   "offset", "folder",
              "kind",   "detail", "v",       "branches", "loops",  "extent", "unit"}) {
            // A space is a value that none takes but texts; what counts is whether it is unknown.
            const RawAnswer answer = server_.ask(get(address + "?" + name + "=+"));
            const bool unknown = answer.body.find("parameter_unknown") != std::string::npos;
            const bool missing = answer.body.find("parameter_missing") != std::string::npos;
            if (!missing) {
                EXPECT_EQ(unknown, !names.contains(name)) << path << " " << name;
            }
        }
    }
}

}  // namespace
}  // namespace ossuary::test
