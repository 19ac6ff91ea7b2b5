#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

#include "engine/core/whole_file.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "tests/server/test_server.h"
#include "tests/support/written_formats.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

class Search : public testing::Test {
protected:
    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
    TestServer server_{index_};

    static const std::string& tree() { return built_models()[4].off; }
    static std::string form(std::string_view field, std::string_view file, std::string_view bytes) {
        return "--b\r\nContent-Disposition: form-data; name=\"" + std::string(field) +
               "\"; filename=\"" + std::string(file) + "\"\r\n\r\n" + std::string(bytes) +
               "\r\n--b--\r\n";
    }
    [[nodiscard]] std::string three_mf_of(const mesh::TriangleMesh& mesh) const {
        const fs::path package =
            write_three_mf(folder_.path() / "query.3mf",
                           three_mf_part(three_mf_object(mesh), "<item objectid=\"1\"/>"));
        return std::string(read_whole_file(package)->view());
    }
    static std::string zip_of(const std::string& ply) {
        const TemporaryFolder folder;
        const auto archive = write_zip(folder.path() / "model.zip",
                                       {{"license.txt", "free"}, {"parts/model.ply", ply}});
        return std::string(read_whole_file(archive)->view());
    }
    static constexpr const char* kForm = "Content-Type: multipart/form-data; boundary=b\r\n";
};

TEST_F(Search, FindsTheUploadedModelFirst) {
    for (const BuiltModel& model : built_models()) {
        const auto json = server_.json(post("/v1/search?limit=3", model.off));
        ASSERT_EQ(json["hits"].size(), 3u) << model.name;
        EXPECT_EQ(json["hits"][0]["name"], model.name);
        EXPECT_EQ(json["hits"][0]["class"], model.class_name);
        EXPECT_EQ(json["hits"][0]["rank"], 1);
        EXPECT_NEAR(json["hits"][0]["distance"].get<double>(), 0.0, 1e-6) << model.name;
        EXPECT_LE(json["hits"][1]["distance"], json["hits"][2]["distance"]);
    }
}

TEST_F(Search, DescribesQueryRankerAndStages) {
    const auto json =
        server_.json(post("/v1/search?ranker=skeleton&pose=0.5&rerank=false", tree()));
    EXPECT_EQ(json["ranker"], "skeleton");
    EXPECT_EQ(json["pose"], 0.5);
    EXPECT_EQ(json["rerank"], false);
    EXPECT_EQ(json["models"], 6);
    EXPECT_GT(json["took_ms"].get<double>(), 0.0);
    EXPECT_TRUE(json["stages_ms"].contains("read"));
    EXPECT_TRUE(json["stages_ms"].contains("rank"));
    const auto& query = json["query"];
    EXPECT_EQ(query["name"], "upload");
    EXPECT_GT(query["vertices"], 0);
    EXPECT_FALSE(query["skeleton"]["nodes"].empty());
    EXPECT_EQ(query["skeleton"]["branches"][0]["points"].size(),
              query["skeleton"]["branches"][0]["radii"].size());
    EXPECT_FALSE(query.contains("mesh"));
    for (const auto& pair : json["hits"][0]["match"]["nodes"]) {
        EXPECT_LT(pair["a"], query["skeleton"]["nodes"].size());
    }
    EXPECT_EQ(json["hits"][0]["matched_nodes"], json["hits"][0]["match"]["nodes"].size());
}

TEST_F(Search, LooksForTheQueryAsAPart) {
    const nlohmann::json json = server_.json(post("/v1/search?part=true", tree()));
    EXPECT_EQ(json["part"], true);
    EXPECT_LT(json["hits"][0]["distance"].get<double>(), 0.1);
    EXPECT_EQ(json["hits"][0]["placement"]["matrix"].size(), 4u);
    const std::string id = json["hits"][0]["id"].dump();
    const nlohmann::json other = json["hits"][1];
    const nlohmann::json compared =
        server_.json(get("/v1/compare?part=true&a=" + id + "&b=" + other["id"].dump()));
    EXPECT_EQ(compared["part"], true);
    for (const char* field : {"matched_nodes", "match"}) {
        EXPECT_EQ(compared[field], other[field]) << field;
    }
}

TEST_F(Search, GivesAPreviewOfTheQueryWhenAsked) {
    const auto mesh =
        server_.json(post("/v1/search?include=mesh&limit=1", tree()))["query"]["mesh"];
    ASSERT_FALSE(mesh["triangles"].empty());
    ASSERT_EQ(mesh["origin"].size(), 3u);
    // Positions are counted from the middle: the greatest is the least with another sign.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto middle = mesh["bounds"]["min"][axis].get<double>() / 2 +
                            mesh["bounds"]["max"][axis].get<double>() / 2;
        EXPECT_NEAR(mesh["origin"][axis].get<double>(), middle, 0.05);
    }
    EXPECT_EQ(mesh["triangles"].size() % 3, 0u);
    EXPECT_LE(mesh["triangles"].size(), 3u * 2000u);
    for (const auto& corner : mesh["triangles"]) EXPECT_LT(corner, mesh["positions"].size() / 3);
    EXPECT_TRUE(mesh["colours"].is_null());
}

TEST_F(Search, GivesColoursUnitAndUprightAxisOfTheQuery) {
    mesh::TriangleMesh painted = mesh::read_mesh(tree(), "tree")->mesh;
    const std::string in_millimetres = three_mf_of(painted);
    constexpr mesh::Colour kOrange = {255, 128, 0};
    painted.corner_colours.assign(painted.triangles.size(), {kOrange, kOrange, kOrange});
    const std::string ply = mesh::to_ply(painted);
    auto query = server_.json(post("/v1/search?include=mesh&limit=1", ply))["query"];
    EXPECT_EQ(query["mesh"]["colours"]["of"], "model");
    EXPECT_EQ(query["mesh"]["colours"]["values"], nlohmann::json({255, 128, 0}));
    EXPECT_TRUE(query["unit"].is_null());
    EXPECT_TRUE(query["metres_per_unit"].is_null());
    EXPECT_TRUE(query["up"] == "y" || query["up"] == "z");
    query = server_.json(post("/v1/search?limit=1", in_millimetres))["query"];
    EXPECT_EQ(query["unit"], "mm");
    EXPECT_EQ(query["metres_per_unit"], 1e-3);
    EXPECT_EQ(query["up"], "z");
    query = server_.json(get("/v1/models/1/similar"))["query"];
    EXPECT_TRUE(query["unit"].is_null());
}

TEST_F(Search, TakesFormsAndNamesTheQueryAfterTheFile) {
    const auto json =
        server_.json(post("/v1/search?limit=1", form("model", "my.tree.off", tree()), kForm));
    EXPECT_EQ(json["query"]["name"], "my.tree");
    EXPECT_EQ(json["hits"][0]["name"], "treea");
    const auto named =
        server_.json(post("/v1/search?name=oak", form("model", "x.off", tree()), kForm));
    EXPECT_EQ(named["query"]["name"], "oak");
}

TEST_F(Search, RefusesFormsWithoutTheModel) {
    EXPECT_EQ(server_.code(post("/v1/search", form("file", "x.off", tree()), kForm), 400),
              "multipart_invalid");
    EXPECT_EQ(server_.code(post("/v1/search", tree(), kForm), 400), "multipart_invalid");
    EXPECT_EQ(server_.code(post("/v1/search", form("model", "x.off", ""), kForm), 400),
              "body_empty");
}

TEST_F(Search, TakesTheContentTypesOfModels) {
    for (const char* type :
         {"model/off", "application/octet-stream", "text/plain; charset=utf-8", "model/stl",
          "text/prs.wavefront-obj", "application/sla", "application/vnd.ms-pki.stl", "model/3mf",
          "model/gltf-binary", "model/gltf+json",
          "application/vnd.ms-package.3dmanufacturing-3dmodel+xml", "application/gzip",
          "application/zip", "application/x-zip-compressed"}) {
        EXPECT_EQ(server_
                      .ask(post("/v1/search?limit=1", tree(),
                                "Content-Type: " + std::string(type) + "\r\n"))
                      .status,
                  200)
            << type;
    }
    EXPECT_EQ(server_.code(post("/v1/search", tree(), "Content-Type: image/png\r\n"), 415),
              "media_type_unsupported");
}

TEST_F(Search, FindsAModelInWhateverFormatItComes) {
    const auto read = mesh::read_mesh(tree(), "tree");
    ASSERT_TRUE(read) << read.error().message;
    const auto best = [&](const std::string& bytes) {
        return server_.json(post("/v1/search?limit=1", bytes), 200)["hits"][0];
    };
    const auto expected = best(tree());
    for (const std::string& bytes :
         {mesh::to_stl(read->mesh), mesh::to_obj(read->mesh), mesh::to_ply(read->mesh),
          to_plain_glb(read->mesh), three_mf_of(read->mesh), zip_of(mesh::to_ply(read->mesh))}) {
        const auto found = best(bytes);
        EXPECT_EQ(found["id"], expected["id"]);
        EXPECT_NEAR(found["distance"].get<double>(), expected["distance"].get<double>(), 0.02);
    }
    EXPECT_EQ(server_.code(post("/v1/search", "ply\nformat ascii 2\nvertex\n"), 422), "ply_header");
}

TEST_F(Search, TakesOfAVolumeWhatTheLabelOrTheThresholdSays) {
    const std::string volume = to_nrrd({30, 30, 30}, [](const Vec3i& at) {
        return at.x() < 10 ? 1 : at.x() >= 20 && at.y() < 10 ? 5 : 0;
    });
    const auto faces = [&](const std::string& query) {
        return server_.json(post("/v1/search?limit=1" + query, volume))["query"]["faces"]
            .get<int>();
    };
    EXPECT_LT(faces("&label=5"), faces("&label=1"));
    EXPECT_EQ(faces("&threshold=2"), faces("&label=5"));
    EXPECT_GT(faces("&threshold=1"), faces("&label=1"));
    EXPECT_EQ(server_.code(post("/v1/search?label=3", volume), 422), "solid_empty");
    EXPECT_EQ(server_.code(post("/v1/search?threshold=1e3", volume), 422), "solid_empty");
}

TEST_F(Search, AnswersOnAfterAFileThatCannotBeRead) {
    const std::string glb = to_plain_glb(mesh::read_mesh(tree(), "tree")->mesh);
    const std::string beside =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"tree.bin"}]})";
    std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
    deep += std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}";
    for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(server_.code(post("/v1/search", glb.substr(0, 400)), 422), "gltf_invalid");
        EXPECT_EQ(server_.code(post("/v1/search", beside), 422), "gltf_buffer");
        EXPECT_EQ(server_.code(post("/v1/search", deep), 422), "reader_crashed");
        EXPECT_EQ(server_.json(post("/v1/search?limit=1", form("model", "tree.glb", glb), kForm),
                               200)["hits"][0]["name"],
                  "treea");
    }
}

TEST_F(Search, NamesTheParameterAtFault) {
    const auto fault = [&](std::string_view query) {
        const auto json = server_.json(post("/v1/search?" + std::string(query), tree()), 400);
        return json.value("code", "") + ":" + json.value("parameter", "");
    };
    for (const char* limit : {"0", "1001", "-1", "1.5", "ten", "", "+1", "1e3"}) {
        EXPECT_EQ(fault("limit=" + std::string(limit)), "parameter_invalid:limit") << limit;
    }
    for (const char* pose : {"-0.1", "1.1", "nan", "inf", "", "half"}) {
        EXPECT_EQ(fault("pose=" + std::string(pose)), "parameter_invalid:pose") << pose;
    }
    EXPECT_EQ(fault("ranker=best"), "parameter_invalid:ranker");
    EXPECT_EQ(fault("rerank=yes"), "parameter_invalid:rerank");
    EXPECT_EQ(fault("part=1"), "parameter_invalid:part");
    EXPECT_EQ(fault("part=true&rerank=true"), "parameter_invalid:rerank");
    EXPECT_EQ(fault("threshold=nan"), "parameter_invalid:threshold");
    EXPECT_EQ(fault("label=one"), "parameter_invalid:label");
    EXPECT_EQ(fault("threshold=1&label=1"), "parameter_invalid:label");
    EXPECT_EQ(fault("include=everything"), "parameter_invalid:include");
    EXPECT_EQ(fault("class="), "parameter_invalid:class");
    EXPECT_EQ(fault("limits=3"), "parameter_unknown:limits");
    EXPECT_EQ(fault("limit=3&limit=4"), "parameter_repeated:limit");
}

TEST_F(Search, FiltersByClass) {
    const auto json = server_.json(post("/v1/search?class=ring", tree()));
    ASSERT_EQ(json["hits"].size(), 2u);
    for (const auto& hit : json["hits"]) EXPECT_EQ(hit["class"], "ring");
    EXPECT_TRUE(server_.json(post("/v1/search?class=nothing", tree()))["hits"].empty());
}

TEST_F(Search, AnswersTheSameForEveryRankerTwice) {
    for (const char* ranker : {"hybrid", "skeleton", "chain-code"}) {
        const std::string request = post("/v1/search?ranker=" + std::string(ranker), tree());
        EXPECT_EQ(server_.json(request)["hits"], server_.json(request)["hits"]) << ranker;
    }
}

std::string bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return std::move(text).str();
}

TEST_F(Search, AnswersBadUploadsWithProblemsAndWritesNothing) {
    const std::string before = bytes_of(index_);
    const auto written = fs::last_write_time(index_);
    std::string binary = "\x89PNG\r\n";
    for (int i = 0; i < 10'000; ++i) binary.push_back(static_cast<char>(i * 37));

    EXPECT_EQ(server_.code(post("/v1/search", ""), 400), "body_empty");
    EXPECT_EQ(server_.code(test::request("POST", "/v1/search"), 411), "length_required");
    const auto truncated =
        server_.json(post("/v1/search", tree().substr(0, tree().size() / 2)), 422);
    EXPECT_EQ(truncated["code"], "off_truncated");
    EXPECT_NE(truncated["detail"].get<std::string>().find("line"), std::string::npos);
    EXPECT_EQ(server_.code(post("/v1/search", binary), 415), "format_unknown");
    EXPECT_EQ(server_.code(post("/v1/search", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"), 422),
              "off_index_out_of_range");
    EXPECT_EQ(server_.code(post("/v1/search", "OFF\n4000000000 1 0\n"), 413),
              "off_too_many_vertices");

    EXPECT_EQ(server_.json(post("/v1/search", tree()))["hits"][0]["name"], "treea");
    EXPECT_EQ(bytes_of(index_), before);
    EXPECT_EQ(fs::last_write_time(index_), written);
}

TEST_F(Search, AnswersSixtyMegabytesOfNonsense) {
    std::string nonsense(60'000'000, ' ');
    std::uint32_t state = 1;
    for (char& c : nonsense) {
        state = state * 1664525u + 1013904223u;
        c = static_cast<char>(state >> 24);
    }
    EXPECT_EQ(server_.code(post("/v1/search", nonsense), 415), "format_unknown");
    EXPECT_EQ(server_.json(get("/livez"))["status"], "ok");
    // The same as numbers that go on for ever.
    std::string numbers = "OFF\n4000000 4000000 0\n";
    while (numbers.size() < 60'000'000) numbers += "0.125 0.25 0.5\n";
    const auto refused = server_.json(post("/v1/search", numbers), 422);
    EXPECT_EQ(refused["code"].get<std::string>().substr(0, 4), "off_");
    EXPECT_EQ(server_.json(get("/livez"))["status"], "ok");
}

TEST_F(Search, RefusesUploadsOverTheLimitAndSaysHowMuchItTakes) {
    const TestServer small(index_,
                           [](server::ServerOptions& options) { options.http.max_body = 1000; });
    const auto refused = small.json(post("/v1/search", std::string(1001, 'x')), 413);
    EXPECT_EQ(refused["code"], "payload_too_large");
    EXPECT_NE(refused["detail"].get<std::string>().find("1000"), std::string::npos);
}

TEST_F(Search, RefusesPagesOfOtherSites) {
    EXPECT_EQ(server_.code(post("/v1/search", tree(), "Sec-Fetch-Site: cross-site\r\n"), 403),
              "cross_site_request");
    EXPECT_EQ(
        server_.ask(post("/v1/search?limit=1", tree(), "Sec-Fetch-Site: same-origin\r\n")).status,
        200);
}

TEST_F(Search, AnswersManyClientsAtOnceAsItAnswersOne) {
    std::vector<nlohmann::json> alone;
    for (const BuiltModel& model : built_models()) {
        alone.push_back(server_.json(post("/v1/search", model.off))["hits"]);
    }
    std::atomic<int> same = 0;
    {
        std::vector<std::jthread> clients;
        for (std::size_t i = 0; i < 12; ++i) {
            clients.emplace_back([&, i] {
                const std::size_t k = i % alone.size();
                if (server_.json(post("/v1/search", built_models()[k].off))["hits"] == alone[k]) {
                    ++same;
                }
            });
        }
    }
    EXPECT_EQ(same, 12);
}

TEST_F(Search, TurnsSearchesAwayWhenTooManyWait) {
    const TestServer busy(index_, [](server::ServerOptions& options) {
        options.searches = 1;
        options.searches_waiting = 0;
    });
    std::atomic<int> answered = 0;
    std::atomic<int> refused = 0;
    std::atomic<int> other = 0;
    {
        std::vector<std::jthread> clients;
        for (int i = 0; i < 8; ++i) {
            clients.emplace_back([&] {
                for (int k = 0; k < 4; ++k) {
                    const RawAnswer answer = busy.ask(post("/v1/search", tree()));
                    if (answer.status == 200) {
                        ++answered;
                    } else if (answer.status == 503 && !answer.header("Retry-After").empty()) {
                        ++refused;
                    } else {
                        ++other;
                    }
                }
            });
        }
    }
    EXPECT_GT(answered, 0);
    EXPECT_GT(refused, 0);
    EXPECT_EQ(other, 0);
    EXPECT_EQ(busy.ask(post("/v1/search", tree())).status, 200);
}

TEST_F(Search, SeesModelsThatAreIndexedMeanwhile) {
    EXPECT_EQ(server_.json(post("/v1/search", tree()))["models"], 6);
    index_model(index_, "newcomer", built_models()[2].off + "# another file\n");
    const auto json = server_.json(post("/v1/search?limit=2", built_models()[2].off));
    EXPECT_EQ(json["models"], 7);
    std::vector<std::string> names = {json["hits"][0]["name"], json["hits"][1]["name"]};
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"newcomer", "ringa"}));
}

TEST_F(Search, FinishesASearchThatIsUnderWayWhenStopped) {
    RawClient client(server_.port());
    client.send(post("/v1/search", tree()));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    server_.stop();
    const RawAnswer answer = client.receive();
    EXPECT_EQ(answer.status, 200);
}

}  // namespace
}  // namespace ossuary::test
