// Who may read, from which pages, and under which path.
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "server/auth.h"
#include "server/options.h"
#include "tests/index/sample_index.h"
#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;
using server::Key;

constexpr const char* kAdminKey = "a-key-for-tests-0123456789";
constexpr const char* kReadKey = "read-key-for-tests-0123";
constexpr const char* kOrigin = "https://shop.example";

class Access : public testing::Test {
protected:
    Access() {
        write_file(folder_.path() / "web/index.html", "<!doctype html><title>gallery</title>");
        write_file(folder_.path() / "admin", std::string(kAdminKey) + "\n");
        write_file(folder_.path() / "read", std::string(kReadKey) + "\n");
    }

    /// Both keys, and the gallery.
    TestServer::Change with_keys() {
        return [this](server::ServerOptions& options) {
            options.admin_key_file = folder_.path() / "admin";
            options.read_key_file = folder_.path() / "read";
            options.web = folder_.path() / "web";
        };
    }
    static TestServer::Change with_origins(std::vector<std::string> origins) {
        return [origins](server::ServerOptions& options) { options.allowed_origins = origins; };
    }
    static std::string bearer(const std::string& key) {
        return "Authorization: Bearer " + key + "\r\n";
    }

    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
};

TEST_F(Access, NeedsTheReadersKeyForEverythingButTheServersHealth) {
    const TestServer server(index_, with_keys());
    for (const char* path : {"/v1/models", "/v1/models/1/thumbnail.png", "/metrics", "/", "/none",
                             "/openapi.yaml", "/v1/nothing"}) {
        const RawAnswer answer = server.ask(get(path));
        EXPECT_EQ(answer.status, 401) << path;
        EXPECT_EQ(answer.header("WWW-Authenticate"), "Basic realm=\"ossuary\", charset=\"UTF-8\"");
        EXPECT_EQ(server.code(get(path), 401), "read_key_missing") << path;
    }
    EXPECT_EQ(server.code(post("/v1/search", "OFF"), 401), "read_key_missing");
    EXPECT_EQ(server.ask(get("/livez")).status, 200);
    EXPECT_EQ(server.ask(get("/readyz")).status, 200);
    EXPECT_EQ(server.ask(request("OPTIONS", "/v1/models")).status, 204);
    for (const std::string& wrong : {std::string("x"), std::string(kReadKey) + "x"}) {
        EXPECT_EQ(server.code(get("/v1/models", bearer(wrong)), 401), "read_key_wrong");
    }
    for (const char* path : {"/v1/models", "/", "/metrics"}) {
        EXPECT_EQ(server.ask(get(path, bearer(kReadKey))).status, 200) << path;
        EXPECT_EQ(server.ask(get(path, bearer(kAdminKey))).status, 200) << path;
    }
    EXPECT_EQ(server.code(request("DELETE", "/v1/models/1", bearer(kReadKey)), 401),
              "admin_key_wrong");
    EXPECT_EQ(server.ask(request("DELETE", "/v1/models/1", bearer(kAdminKey))).status, 204);
}

TEST_F(Access, TakesTheReadersKeyAsThePasswordThatBrowsersAskFor) {
    const TestServer server(index_, with_keys());
    const auto basic = [](const std::string& credentials) {
        return get("/v1/models", "Authorization: Basic " + credentials + "\r\n");
    };
    // "anna:read-key-for-tests-0123", ":read-key-for-tests-0123", and without the padding.
    EXPECT_EQ(server.ask(basic("YW5uYTpyZWFkLWtleS1mb3ItdGVzdHMtMDEyMw==")).status, 200);
    EXPECT_EQ(server.ask(basic("OnJlYWQta2V5LWZvci10ZXN0cy0wMTIz")).status, 200);
    EXPECT_EQ(server.ask(basic("YW5uYTpyZWFkLWtleS1mb3ItdGVzdHMtMDEyMw")).status, 200);
    EXPECT_EQ(server
                  .ask(get("/v1/models",
                           "authorization: bAsIc OnJlYWQta2V5LWZvci10ZXN0cy0wMTIz"
                           "\r\n"))
                  .status,
              200);
    // "anna:wrong", no colon, no base64, nothing.
    EXPECT_EQ(server.code(basic("YW5uYTp3cm9uZw=="), 401), "read_key_wrong");
    EXPECT_EQ(server.code(basic("cmVhZC1rZXktZm9yLXRlc3RzLTAxMjM="), 401), "read_key_missing");
    EXPECT_EQ(server.code(basic("#"), 401), "read_key_missing");
    EXPECT_EQ(server.code(basic(""), 401), "read_key_missing");
}

TEST_F(Access, FollowsTheFilesOfItsKeys) {
    const TestServer server(index_, with_keys());
    const std::string later = "another-key-for-tests-1";
    write_file(folder_.path() / "read", later);
    EXPECT_EQ(server.code(get("/v1/models", bearer(kReadKey)), 401), "read_key_wrong");
    EXPECT_EQ(server.ask(get("/v1/models", bearer(later))).status, 200);
    // What cannot be a key, and no file: the last key stays.
    write_file(folder_.path() / "read", "short");
    EXPECT_EQ(server.ask(get("/v1/models", bearer(later))).status, 200);
    EXPECT_EQ(server.code(get("/v1/models", bearer("short")), 401), "read_key_wrong");
    fs::remove(folder_.path() / "read");
    EXPECT_EQ(server.ask(get("/v1/models", bearer(later))).status, 200);
    write_file(folder_.path() / "admin", "the-next-administrators-key");
    EXPECT_EQ(server.code(request("DELETE", "/v1/models/1", bearer(kAdminKey)), 401),
              "read_key_wrong");
    EXPECT_EQ(
        server.ask(request("DELETE", "/v1/models/1", bearer("the-next-administrators-key"))).status,
        204);
}

TEST_F(Access, RefusesAShortKey) {
    const auto load = [&](const char* name) {
        return Key::load(folder_.path() / name, "OSSUARY_NO_SUCH_KEY", "administrator's key");
    };
    write_file(folder_.path() / "short", "short\n");
    EXPECT_EQ(load("short").error().code, ErrorCode::kInvalidArgument);
    EXPECT_EQ(load("none").error().code, ErrorCode::kFileUnreadable);
    const auto key = load("admin");
    ASSERT_TRUE(key);
    EXPECT_TRUE(key->exists());
    EXPECT_TRUE(key->opens(kAdminKey));
    EXPECT_FALSE(key->opens(""));
    const auto none = Key::load({}, "OSSUARY_NO_SUCH_KEY", "administrator's key");
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->exists());
    EXPECT_FALSE(none->opens(""));
}

TEST_F(Access, LetsPagesOfNamedOriginsReadAnswers) {
    const TestServer server(index_, with_origins({kOrigin, "http://127.0.0.1:9000"}));
    const std::string from_shop = std::string("Origin: ") + kOrigin + "\r\n";
    const RawAnswer answer = server.ask(get("/v1/models", from_shop));
    EXPECT_EQ(answer.header("Access-Control-Allow-Origin"), kOrigin);
    EXPECT_EQ(answer.header("Vary"), "Origin");
    EXPECT_EQ(answer.header("Cross-Origin-Resource-Policy"), "cross-origin");
    EXPECT_NE(answer.header("Access-Control-Expose-Headers").find("X-Request-Id"),
              std::string::npos);
    EXPECT_EQ(server.ask(get("/v1/nothing", from_shop)).header("Access-Control-Allow-Origin"),
              kOrigin);
    for (const char* headers : {"", "Origin: https://shop.example.org\r\n", "Origin: null\r\n"}) {
        const RawAnswer other = server.ask(get("/v1/models", headers));
        EXPECT_EQ(other.header("Access-Control-Allow-Origin"), "") << headers;
        EXPECT_EQ(other.header("Vary"), "Origin");
        EXPECT_EQ(other.header("Cross-Origin-Resource-Policy"), "same-origin");
    }
    const RawAnswer asked =
        server.ask(request("OPTIONS", "/v1/search",
                           from_shop + "Access-Control-Request-Method: POST\r\n"
                                       "Access-Control-Request-Headers: content-type\r\n"));
    EXPECT_EQ(asked.status, 204);
    EXPECT_NE(asked.header("Access-Control-Allow-Methods").find("POST"), std::string::npos);
    EXPECT_NE(asked.header("Access-Control-Allow-Headers").find("Content-Type"), std::string::npos);
    EXPECT_EQ(asked.header("Access-Control-Max-Age"), "600");
    const RawAnswer stranger =
        server.ask(request("OPTIONS", "/v1/search",
                           "Origin: https://a.example\r\nAccess-Control-Request-Method: POST\r\n"));
    EXPECT_EQ(stranger.header("Access-Control-Allow-Methods"), "");

    const std::string cross_site = "Sec-Fetch-Site: cross-site\r\n";
    const std::string& model = built_models().front().off;
    EXPECT_EQ(server.ask(post("/v1/search", model, cross_site + from_shop)).status, 200);
    EXPECT_EQ(server.code(post("/v1/search", model, cross_site), 403), "cross_site_request");
    EXPECT_EQ(
        server.code(post("/v1/search", model, cross_site + "Origin: https://a.example\r\n"), 403),
        "cross_site_request");
}

TEST_F(Access, LetsAllOriginsInOrNone) {
    const std::string from_anywhere = "Origin: https://a.example\r\n";
    const TestServer all(index_, with_origins({"*"}));
    EXPECT_EQ(all.ask(get("/v1/models", from_anywhere)).header("Access-Control-Allow-Origin"),
              "https://a.example");
    const TestServer none(index_);
    const RawAnswer answer = none.ask(get("/v1/models", from_anywhere));
    EXPECT_EQ(answer.header("Access-Control-Allow-Origin"), "");
    EXPECT_EQ(answer.header("Vary").find("Origin"), std::string::npos);
}

TEST_F(Access, AnswersBelowItsBasePath) {
    const TestServer server(index_, [this](server::ServerOptions& options) {
        options.http.base_path = "/shop/models";
        options.web = folder_.path() / "web";
        options.admin_key_file = folder_.path() / "admin";
    });
    const auto model = server.json(get("/shop/models/v1/models/1"));
    EXPECT_EQ(model["links"]["mesh"], "/shop/models/v1/models/1/mesh");
    EXPECT_EQ(server.ask(get(model["links"]["mesh"].get<std::string>())).status, 200);
    EXPECT_EQ(server.ask(get("/shop/models/")).status, 200);
    const RawAnswer folder = server.ask(get("/shop/models"));
    EXPECT_EQ(folder.status, 308);
    EXPECT_EQ(folder.header("Location"), "/shop/models/");
    EXPECT_EQ(server.code(get("/shop/modelsv1/models"), 404), "file_not_served");
    EXPECT_EQ(server.code(get("/shop/models/shop/models/v1/models"), 404), "file_not_served");
    // A proxy may take the path off itself.
    EXPECT_EQ(server.json(get("/v1/models/1"))["links"], model["links"]);

    const auto hits = server.json(get("/shop/models/v1/models/1/similar?limit=2"))["hits"];
    EXPECT_EQ(server.ask(get(hits[0]["thumbnail"].get<std::string>())).status, 200);
    const RawAnswer added = server.ask(
        post("/shop/models/v1/models?name=new", built_models().front().off, bearer(kAdminKey)));
    EXPECT_EQ(added.status, 202);
    EXPECT_EQ(added.header("Location").find("/shop/models/v1/jobs/"), 0U);
    const auto reports = server.json(get("/shop/models/v1/evaluations"))["evaluations"];
    for (const auto& report : reports) {
        EXPECT_EQ(report["links"]["json"].get<std::string>().find("/shop/models/v1/"), 0U);
    }
}

TEST(AccessOptions, AreTakenAsTheyAreMeant) {
    const auto parse = [](const char* option, const char* value) {
        const std::array arguments = {"ossuary-server", "--index", "x", option, value};
        return server::parse_options(static_cast<int>(arguments.size()), arguments.data());
    };
    EXPECT_EQ(parse("--base-path", "/shop/models").options.http.base_path, "/shop/models");
    for (const char* wrong :
         {"/", "shop", "/shop/", "//shop", "/a/../b", "/a b", "/a?b", "/a%20b"}) {
        EXPECT_FALSE(parse("--base-path", wrong).run) << wrong;
    }
    EXPECT_EQ(
        parse("--allow-origin", "https://a.example,http://b:1").options.allowed_origins.size(), 2U);
    EXPECT_FALSE(parse("--allow-origin", "a.example").run);
    EXPECT_EQ(parse("--read-key-file", "k").options.read_key_file, "k");
}

}  // namespace
}  // namespace ossuary::test
