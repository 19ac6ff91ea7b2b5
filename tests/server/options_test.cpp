#include "server/options.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/core/whole_file.h"
#include "server/server.h"
#include "tests/support/temporary_folder.h"

namespace ossuary::server {
namespace {

namespace fs = std::filesystem;

class Options : public testing::Test {
protected:
    ~Options() override {
        for (const std::string& name : set_) ::unsetenv(name.c_str());
    }
    ParsedOptions parse(const std::vector<std::string>& words) {
        std::vector<const char*> arguments = {"ossuary-server"};
        for (const std::string& word : words) arguments.push_back(word.c_str());
        return parse_options(static_cast<int>(arguments.size()), arguments.data());
    }
    void set(const std::string& name, const std::string& value) {
        ::setenv(name.c_str(), value.c_str(), 1);
        set_.push_back(name);
    }
    std::string file(const std::string& text) {
        const fs::path path = folder_.path() / "server.conf";
        EXPECT_TRUE(write_whole_file(path, text));
        return path.string();
    }

    test::TemporaryFolder folder_;

private:
    std::vector<std::string> set_;
};

TEST_F(Options, OfTheCommandLineWinOverTheEnvironmentAndThatOverTheFile) {
    const std::string config = file("index = \"a.ossuary\"\nport = 1\nthreads = 2\nsearches = 3\n");
    set("OSSUARY_PORT", "11");
    set("OSSUARY_THREADS", "12");
    const ParsedOptions parsed = parse({"--config", config, "--port", "21"});
    ASSERT_TRUE(parsed.run);
    EXPECT_EQ(parsed.options.index, "a.ossuary");
    EXPECT_EQ(parsed.options.port, 21);
    EXPECT_EQ(parsed.options.http.threads, 12u);
    EXPECT_EQ(parsed.options.searches, 3u);
    EXPECT_NE(parsed.options.effective.find("port=21"), std::string::npos)
        << parsed.options.effective;
}

TEST_F(Options, AreFlagsAndListsToo) {
    set("OSSUARY_INDEX", "a.ossuary");
    set("OSSUARY_SERVE_FILES", "true");
    set("OSSUARY_ALLOW_HOST", "a.example,b.example");
    EXPECT_EQ(parse({}).options.allowed_hosts,
              (std::vector<std::string>{"a.example", "b.example"}));
    EXPECT_TRUE(parse({}).options.serve_files);
    EXPECT_FALSE(parse({"--serve-files=false"}).options.serve_files);
    set("OSSUARY_CONFIG", file("log-json = true\nallow-host = [\"c.example\"]\n"));
    EXPECT_TRUE(parse({}).options.log.json);
    EXPECT_EQ(parse({}).options.allowed_hosts,
              (std::vector<std::string>{"a.example", "b.example"}));
}

TEST_F(Options, ThatAreNoneAreRefusedWhereverTheyStand) {
    const std::string index = "--index=a.ossuary";
    EXPECT_EQ(parse({"--config", file("index=\"a\"\nprot = 8080\n")}).exit_status, 2);
    EXPECT_EQ(parse({"--config", file("index=\"a\"\nport = 70000\n")}).exit_status, 2);
    EXPECT_EQ(parse({"--config", (folder_.path() / "gone.conf").string(), index}).exit_status, 2);
    EXPECT_EQ(parse({}).exit_status, 2);
    set("OSSUARY_PORT", "many");
    testing::internal::CaptureStderr();
    EXPECT_EQ(parse({index}).exit_status, 2);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("--port=many"), std::string::npos);
}

TEST_F(Options, CanBeCheckedWithoutServing) {
    ServerOptions options;
    options.index = folder_.path() / "new.ossuary";
    const auto missing = Server::check(options);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::kIndexNotFound);
    options.create = true;
    EXPECT_TRUE(Server::check(options));
    EXPECT_TRUE(fs::exists(options.index));
    options.create = false;
    EXPECT_TRUE(Server::check(options));
    options.web = folder_.path() / "no gallery";
    EXPECT_FALSE(Server::check(options));
}

}  // namespace
}  // namespace ossuary::server
