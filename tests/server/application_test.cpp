#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "server/application.h"
#include "server/auth.h"
#include "server/options.h"
#include "server/router.h"
#include "tests/index/sample_index.h"
#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kKey = "a-key-for-tests-0123456789";

class Application : public testing::Test {
protected:
    Application() {
        const fs::path web = folder_.path() / "web";
        write_file(web / "index.html", "<!doctype html><title>gallery</title>");
        write_file(web / "assets/index-B4x_9dKq.js", "export {};" + std::string(3000, ' '));
        write_file(web / "assets/plain.css", "a{}");
        write_file(web / "notes.secret", "secret");
        write_file(folder_.path() / "secret.txt", "secret");
        fs::create_symlink(folder_.path() / "secret.txt", web / "link.txt");
        write_file(folder_.path() / "key", std::string(kKey) + "\n");
    }

    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
    TestServer::Change with_key() {
        return [this](server::ServerOptions& options) {
            options.admin_key_file = folder_.path() / "key";
        };
    }
    TestServer::Change with_gallery() {
        return [this](server::ServerOptions& options) { options.web = folder_.path() / "web"; };
    }
    static std::string bearer(std::string_view key) {
        return "Authorization: Bearer " + std::string(key) + "\r\n";
    }
};

TEST_F(Application, ServesTheGallery) {
    const TestServer server(index_, with_gallery());
    const RawAnswer page = server.ask(get("/"));
    EXPECT_EQ(page.status, 200);
    EXPECT_EQ(page.header("Content-Type"), "text/html; charset=utf-8");
    EXPECT_EQ(page.header("Cache-Control"), "no-cache");
    EXPECT_NE(page.header("Content-Security-Policy").find("default-src 'self'"), std::string::npos);
    EXPECT_EQ(page.header("Access-Control-Allow-Origin"), "");
    const RawAnswer script = server.ask(get("/assets/index-B4x_9dKq.js"));
    EXPECT_EQ(script.header("Content-Type"), "text/javascript; charset=utf-8");
    EXPECT_NE(script.header("Cache-Control").find("immutable"), std::string::npos);
    EXPECT_EQ(server.ask(get("/assets/plain.css")).header("Cache-Control"), "no-cache");
    EXPECT_EQ(server.ask(test::request("HEAD", "/"), true).status, 200);
}

TEST_F(Application, RevalidatesTheGalleryWithTheHeadersOfTheWholeAnswer) {
    const TestServer server(index_, with_gallery());
    for (const char* path : {"/", "/assets/plain.css", "/assets/index-B4x_9dKq.js"}) {
        const RawAnswer whole = server.ask(get(path));
        const RawAnswer again =
            server.ask(get(path, "If-None-Match: " + whole.header("ETag") + "\r\n"));
        EXPECT_EQ(again.status, 304) << path;
        EXPECT_EQ(again.body, "") << path;
        // A browser takes them over into its copy (RFC 9111, section 4.3.4).
        for (const char* name : {"Content-Security-Policy", "Cache-Control", "ETag"}) {
            EXPECT_EQ(again.header(name), whole.header(name)) << path << " " << name;
        }
    }
}

TEST_F(Application, ServesNothingOutsideTheGallery) {
    const TestServer server(index_, with_gallery());
    for (const char* path :
         {"/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt",
          "/..%5csecret.txt", "//etc/passwd", "/./index.html", "/assets", "/assets/", "/link.txt",
          "/notes.secret", "/index.html/", "/INDEX.HTML", "/key", "/..;/secret.txt"}) {
        const RawAnswer answer = server.ask(get(path));
        EXPECT_TRUE(answer.status == 404 || answer.status == 400) << path << answer.status;
        EXPECT_EQ(answer.body.find("secret\n"), std::string::npos) << path;
        EXPECT_EQ(answer.header("Content-Type"), "application/problem+json") << path;
    }
}

TEST_F(Application, StartsWithoutAGallery) {
    const TestServer server(index_);
    EXPECT_EQ(server.code(get("/"), 404), "file_not_served");
    EXPECT_EQ(server.json(get("/readyz"))["status"], "ok");
}

TEST_F(Application, NamesTheMethodsOfAPath) {
    const TestServer server(index_, with_gallery());
    const auto allow = [&](std::string_view method, std::string_view path) {
        const RawAnswer answer = server.ask(test::request(method, path));
        EXPECT_TRUE(answer.status == 405 || answer.status == 204) << answer.status;
        return answer.header("Allow");
    };
    EXPECT_EQ(allow("PUT", "/v1/models/1"), "GET, HEAD, PATCH, DELETE, OPTIONS");
    EXPECT_EQ(allow("GET", "/v1/search"), "POST, OPTIONS");
    EXPECT_EQ(allow("DELETE", "/"), "GET, HEAD, OPTIONS");
    EXPECT_EQ(allow("OPTIONS", "/v1/models"), "GET, HEAD, POST, OPTIONS");
    EXPECT_EQ(server.code(test::request("PUT", "/v1/models/1"), 405), "method_not_allowed");
    EXPECT_EQ(server.code(test::request("BREW", "/v1/models/1"), 501), "method_unknown");
    EXPECT_EQ(server.code(test::request("GET", "/v1/nothing"), 404), "route_not_found");
    EXPECT_EQ(server.ask(test::request("OPTIONS", "*")).status, 204);
    EXPECT_EQ(server.ask(test::request("HEAD", "/v1/models"), true).status, 200);
}

TEST_F(Application, AnswersOnlyToItsOwnNames) {
    const TestServer server(index_);
    const auto status = [&](const TestServer& asked, std::string_view host) {
        return asked.ask("GET /livez HTTP/1.1\r\nHost: " + std::string(host) + "\r\n\r\n").status;
    };
    for (const char* host :
         {"localhost", "LOCALHOST:8080", "127.0.0.1:80", "127.1.2.3", "[::1]:80"}) {
        EXPECT_EQ(status(server, host), 200) << host;
    }
    for (const char* host : {"evil.example", "127.0.0.1.evil.example", "localhost.evil.example:80",
                             "", "0.0.0.0", "[::2]"}) {
        EXPECT_EQ(status(server, host), 421) << host;
    }
    const TestServer named(
        index_, [](server::ServerOptions& options) { options.allowed_hosts = {"models.example"}; });
    EXPECT_EQ(status(named, "models.example:443"), 200);
    EXPECT_EQ(status(named, "other.example"), 421);
}

TEST_F(Application, SetsTheHeadersThatProtectPages) {
    const TestServer server(index_);
    for (const std::string& bytes : {get("/livez"), get("/nothing"), get("/x", "A : b\r\n")}) {
        const RawAnswer answer = server.ask(bytes);
        EXPECT_EQ(answer.header("X-Content-Type-Options"), "nosniff");
        EXPECT_EQ(answer.header("Referrer-Policy"), "no-referrer");
        EXPECT_EQ(answer.header("X-Frame-Options"), "DENY");
        EXPECT_FALSE(answer.header("Content-Security-Policy").empty());
        EXPECT_EQ(answer.count("X-Request-Id"), 1u);
    }
}

TEST_F(Application, RefusesAdministrationWithoutAKey) {
    const TestServer server(index_);
    EXPECT_EQ(server.code(post("/v1/models", "OFF", bearer(kKey)), 403), "admin_disabled");
    EXPECT_EQ(server.code(test::request("DELETE", "/v1/models/1", bearer("")), 403),
              "admin_disabled");
}

TEST_F(Application, RefusesWrongKeysBeforeTheBodyIsRead) {
    const TestServer server(index_, with_key());
    RawClient client(server.port());
    client.send(
        test::request("POST", "/v1/models", "Content-Length: 1000\r\nExpect: 100-continue\r\n"));
    const RawAnswer answer = client.receive();
    EXPECT_EQ(answer.status, 401);
    EXPECT_EQ(client.interim_answers(), 0);
    EXPECT_EQ(answer.header("WWW-Authenticate"), "Bearer realm=\"ossuary\"");
    const std::string key = kKey;
    for (const std::string& wrong : {key + "x", key.substr(1), std::string("x"), std::string()}) {
        const std::string code =
            server.code(test::request("DELETE", "/v1/models/1", bearer(wrong)), 401);
        EXPECT_EQ(code, wrong.empty() ? "admin_key_missing" : "admin_key_wrong");
    }
    EXPECT_EQ(
        server.code(test::request("DELETE", "/v1/models/1", "Authorization: Basic " + key + "\r\n"),
                    401),
        "admin_key_missing");
    EXPECT_EQ(server.json(get("/v1/models"))["total"], 6);
}

nlohmann::json finished_job(const TestServer& server, const std::string& location) {
    nlohmann::json job;
    for (int i = 0; i < 500; ++i) {
        job = server.json(get(location));
        if (job["state"] == "done" || job["state"] == "failed") return job;
        std::this_thread::sleep_for(20ms);
    }
    return job;
}

TEST_F(Application, AddsAndRemovesModels) {
    const TestServer server(index_, with_key());
    const RawAnswer added =
        server.ask(post("/v1/models?name=oak&class=tree",
                        built_models()[4].off + "# another file\n", bearer(kKey)));
    ASSERT_EQ(added.status, 202) << added.body;
    const std::string location = added.header("Location");
    EXPECT_EQ(nlohmann::json::parse(added.body)["job"], location);
    const auto job = finished_job(server, location);
    ASSERT_EQ(job["state"], "done") << job;
    const std::string path = "/v1/models/" + std::to_string(job["model"].get<int>());
    const auto model = server.json(get(path));
    EXPECT_EQ(model["name"], "oak");
    EXPECT_EQ(model["class"], "tree");
    EXPECT_EQ(server.json(post("/v1/search", built_models()[4].off))["models"], 7);

    EXPECT_EQ(server.ask(test::request("DELETE", path, bearer(kKey))).status, 204);
    EXPECT_EQ(server.code(get(path), 404), "model_not_found");
    EXPECT_EQ(server.code(test::request("DELETE", path, bearer(kKey)), 404), "model_not_found");
    EXPECT_EQ(server.json(post("/v1/search", built_models()[4].off))["models"], 6);
}

TEST_F(Application, TurnsModels) {
    const TestServer server(index_, with_key());
    const auto patch = [](const std::string& target, const std::string& headers) {
        return test::request("PATCH", target, headers);
    };
    const std::string picture = server.ask(get("/v1/models/5/thumbnail.png")).body;
    const std::string before = server.json(get("/v1/models/5"))["up"];
    const std::string other = before == "y" ? "z" : "y";
    const RawAnswer turned = server.ask(patch("/v1/models/5?up=" + other, bearer(kKey)));
    ASSERT_EQ(turned.status, 200) << turned.body;
    EXPECT_EQ(nlohmann::json::parse(turned.body), server.json(get("/v1/models/5")));
    EXPECT_EQ(server.json(get("/v1/models/5"))["up"], other);
    EXPECT_EQ(server.json(get("/v1/compare?a=5&b=1"))["a"]["up"], other);
    EXPECT_NE(server.ask(get("/v1/models/5/thumbnail.png")).body, picture);
    EXPECT_EQ(server.ask(patch("/v1/models/5?up=auto", bearer(kKey))).status, 200);
    EXPECT_EQ(server.json(get("/v1/models/5"))["up"], before);

    EXPECT_EQ(server.code(patch("/v1/models/5", bearer(kKey)), 400), "parameter_missing");
    EXPECT_EQ(server.code(patch("/v1/models/5?up=w", bearer(kKey)), 400), "parameter_invalid");
    EXPECT_EQ(server.code(patch("/v1/models/99?up=z", bearer(kKey)), 404), "model_not_found");
    EXPECT_EQ(server.code(patch("/v1/models/5?up=z", ""), 401), "admin_key_missing");
}

TEST_F(Application, ChangesTheClassOfModels) {
    const TestServer server(index_, with_key());
    const auto patch = [](const std::string& target) {
        return test::request("PATCH", target, bearer(kKey));
    };
    const RawAnswer changed = server.ask(patch("/v1/models/5?class=old%20oak"));
    ASSERT_EQ(changed.status, 200) << changed.body;
    EXPECT_EQ(nlohmann::json::parse(changed.body)["class"], "old oak");
    EXPECT_EQ(server.json(get("/v1/models?class=old%20oak"))["total"], 1);
    EXPECT_EQ(server.ask(patch("/v1/models/5?class=")).status, 200);
    EXPECT_TRUE(server.json(get("/v1/models/5"))["class"].is_null());
    EXPECT_EQ(server.code(patch("/v1/models/99?class=x"), 404), "model_not_found");
    EXPECT_EQ(server.code(test::request("PATCH", "/v1/models/5?class=x"), 401),
              "admin_key_missing");
}

TEST_F(Application, TellsAdministratorsWhatCouldNotBeIndexed) {
    EXPECT_ANY_THROW(index_model(index_, "knot", "OFF\n3 1 0\n0 0 0\n"));
    const TestServer server(index_, with_key());
    EXPECT_EQ(server.code(get("/v1/failures"), 401), "admin_key_missing");
    EXPECT_EQ(server.code(get("/v1/jobs"), 401), "admin_key_missing");
    const RawAnswer answer = server.ask(get("/v1/failures", bearer(kKey)));
    ASSERT_EQ(answer.status, 200) << answer.body;
    EXPECT_EQ(server.code(get("/v1/failures?limit=1", bearer(kKey)), 400), "parameter_unknown");
    const auto failures = nlohmann::json::parse(answer.body)["failures"];
    ASSERT_EQ(failures.size(), 1u);
    EXPECT_EQ(failures[0]["code"], "off_truncated");
    EXPECT_EQ(failures[0]["path"], "knot.off");
    EXPECT_EQ(answer.body.find(folder_.path().string()), std::string::npos) << answer.body;
}

TEST_F(Application, LetsOnlyNamedPagesShowModelsInAFrame) {
    write_file(folder_.path() / "web/embed.html", "<!doctype html>");
    const TestServer closed(index_, with_gallery());
    EXPECT_EQ(closed.ask(get("/embed.html")).header("X-Frame-Options"), "DENY");
    EXPECT_FALSE(closed.json(get("/v1/models/1"))["links"].contains("embed"));
    const TestServer open(index_, [&](server::ServerOptions& options) {
        with_gallery()(options);
        options.embedders = {"https://shop.example", "http://127.0.0.1:9000"};
    });
    const RawAnswer frame = open.ask(get("/embed.html"));
    EXPECT_EQ(frame.count("X-Frame-Options"), 0u);
    EXPECT_NE(frame.header("Content-Security-Policy")
                  .find("frame-ancestors https://shop.example http://127.0.0.1:9000"),
              std::string::npos);
    // The gallery itself stays out of frames.
    EXPECT_EQ(open.ask(get("/")).header("X-Frame-Options"), "DENY");
    EXPECT_NE(open.ask(get("/")).header("Content-Security-Policy").find("frame-ancestors 'none'"),
              std::string::npos);
    EXPECT_EQ(open.json(get("/v1/models/1"))["links"]["embed"], "/embed.html#/models/1");
}

TEST(ServerOptions, TakeOnlyOriginsForThoseWhoMayEmbed) {
    const auto allows = [](const char* origin) {
        const std::array arguments = {"ossuary-server", "--index", "x", "--allow-embedding",
                                      origin};
        return server::parse_options(static_cast<int>(arguments.size()), arguments.data()).run;
    };
    for (const char* origin : {"https://a.example", "http://localhost:8000", "*"}) {
        EXPECT_TRUE(allows(origin)) << origin;
    }
    for (const char* origin :
         {"https://a.example; script-src *", "a.example", "https://", "'self'"}) {
        EXPECT_FALSE(allows(origin)) << origin;
    }
}

TEST_F(Application, RefusesToQueueWhatCannotBeRead) {
    const TestServer server(index_, with_key());
    EXPECT_EQ(server.code(post("/v1/models", "OFF\n3 1 0\n0 0 0\n", bearer(kKey)), 422),
              "off_truncated");
    EXPECT_EQ(server.code(post("/v1/models?limit=3", "OFF", bearer(kKey)), 400),
              "parameter_unknown");
    EXPECT_EQ(server.code(get("/v1/jobs/1"), 404), "job_not_found");
    EXPECT_EQ(server.code(get("/v1/jobs/x"), 400), "parameter_invalid");
}

TEST_F(Application, ReportsAModelThatHasNoSkeletonAsAFailedJob) {
    const TestServer server(index_, with_key());
    const std::string point = "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n";
    const RawAnswer added = server.ask(post("/v1/models", point, bearer(kKey)));
    ASSERT_EQ(added.status, 202) << added.body;
    const auto job = finished_job(server, added.header("Location"));
    EXPECT_EQ(job["state"], "failed");
    EXPECT_TRUE(job["model"].is_null());
    EXPECT_FALSE(job["error"]["code"].get<std::string>().empty());
    EXPECT_EQ(server.json(get("/v1/models"))["total"], 6);
}

TEST_F(Application, CountsWhatItDoes) {
    const TestServer server(index_);
    server.ask(post("/v1/search", built_models()[0].off));
    server.ask(get("/v1/nothing"));
    const std::vector<std::string> lines = {
        "ossuary_http_requests_total{",
        "route=\"/v1/search\"",
        "status=\"200\"",
        "ossuary_http_problems_total{code=\"route_not_found\"} 1",
        "ossuary_search_stage_duration_seconds_bucket{stage=\"rank\"",
        "ossuary_index_models 6",
        "ossuary_http_received_bytes_total"};
    std::string text;
    const auto has = [&text](const std::string& line) {
        return text.find(line) != std::string::npos;
    };
    // A request is counted once its answer has been sent, which may be after the client has it.
    for (int i = 0; i < 100 && !std::all_of(lines.begin(), lines.end(), has); ++i) {
        text = server.ask(get("/metrics")).body;
    }
    for (const std::string& line : lines) EXPECT_TRUE(has(line)) << line;
}

TEST_F(Application, RefusesToStartOnWhatIsNotAnIndex) {
    const auto error = [](const fs::path& index) {
        server::ServerOptions options;
        options.index = index;
        options.port = 0;
        options.log.level = "off";
        const auto opened = server::Server::open(options);
        return opened ? std::string("opened") : std::string(to_string(opened.error().code));
    };
    EXPECT_EQ(error(folder_.path() / "none"), "index_not_found");
    write_file(folder_.path() / "text", "this is not an index");
    EXPECT_EQ(error(folder_.path() / "text"), "index_foreign");
}

TEST(ConstantTime, ComparesWholeTexts) {
    EXPECT_TRUE(server::equal_in_constant_time("", ""));
    EXPECT_TRUE(server::equal_in_constant_time("abc", "abc"));
    EXPECT_FALSE(server::equal_in_constant_time("abc", "abd"));
    EXPECT_FALSE(server::equal_in_constant_time("abcabc", "abc"));
    EXPECT_FALSE(server::equal_in_constant_time("abc", "abcabc"));
    EXPECT_FALSE(server::equal_in_constant_time("", "abc"));
    EXPECT_FALSE(server::equal_in_constant_time("abc", ""));
}

TEST(Routes, MatchOneCharacterOrMoreOfOneSegment) {
    using server::match_pattern;
    EXPECT_EQ(match_pattern("/v1/models/{id}", "/v1/models/7"), "7");
    EXPECT_EQ(match_pattern("/v1/models/{id}/mesh", "/v1/models/7/mesh"), "7");
    EXPECT_EQ(match_pattern("/e/{r}.csv", "/e/hybrid.csv"), "hybrid");
    EXPECT_EQ(match_pattern("/v1/models/{id}", "/v1/models/"), std::nullopt);
    EXPECT_EQ(match_pattern("/v1/models/{id}", "/v1/models/7/mesh"), std::nullopt);
    EXPECT_EQ(match_pattern("/e/{r}.csv", "/e/.csv"), std::nullopt);
    EXPECT_EQ(match_pattern("/livez", "/livez/"), std::nullopt);
}

TEST(StaticFiles, TellsHashedNames) {
    EXPECT_TRUE(server::is_hashed_name("index-B4x_9dKq.js"));
    EXPECT_TRUE(server::is_hashed_name("index-B4x_9dKq.js.map"));
    EXPECT_FALSE(server::is_hashed_name("index.html"));
    EXPECT_FALSE(server::is_hashed_name("index-abc.js"));
    EXPECT_FALSE(server::is_hashed_name("well-describes.js"));
    EXPECT_FALSE(server::is_hashed_name("favicon.svg"));
}

TEST(GalleryFolder, IsFoundAboveTheProgram) {
    const TemporaryFolder folder;
    write_file(folder.path() / "web/dist/index.html", "x");
    fs::create_directories(folder.path() / "build/release/bin");
    EXPECT_EQ(server::find_web_folder(folder.path() / "build/release/bin/ossuary-server"),
              folder.path() / "web/dist");
}

}  // namespace
}  // namespace ossuary::test
