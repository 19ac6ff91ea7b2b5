#include "tests/server/test_server.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "engine/mesh/write_mesh.h"
#include "index/indexer.h"
#include "index/store.h"
#include "tests/index/sample_index.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

index::IndexParameters parameters() {
    index::IndexParameters chosen;
    chosen.resolution = 32;
    return chosen;
}

void index_folder(const fs::path& index, const fs::path& folder,
                  const ranking::Classification& classes) {
    auto store = index::Store::create_or_open(index, parameters());
    if (!store) throw std::runtime_error(store.error().message);
    index::IndexOptions options;
    options.paths = {folder};
    options.jobs = 1;
    if (!classes.classes.empty()) options.classes = classes;
    index::ProgressSink quiet;
    const auto outcome = index::index_models(*store, options, quiet);
    if (!outcome) throw std::runtime_error(outcome.error().message);
    if (outcome->failed > 0) throw std::runtime_error("a built model could not be indexed");
    if (const auto done = store->checkpoint(); !done) {
        throw std::runtime_error(done.error().message);
    }
}

std::vector<BuiltModel> build_models() {
    Mat3 stretched = Mat3::Identity();
    stretched(0, 0) = 1.3;
    const auto add = [](std::vector<BuiltModel>& models, const char* class_name, const char* letter,
                        const mesh::TriangleMesh& mesh) {
        models.push_back({std::string(class_name) + letter, class_name, mesh::to_off(mesh)});
    };
    std::vector<BuiltModel> models;
    add(models, "ball", "a", icosphere_mesh(Vec3::Zero(), 1.0));
    add(models, "ball", "b", transformed(icosphere_mesh(Vec3::Zero(), 1.0), stretched));
    add(models, "ring", "a", torus_mesh(2.0, 0.5));
    add(models, "ring", "b", transformed(torus_mesh(2.0, 0.6), stretched));
    add(models, "tree", "a", capsule_tree_mesh());
    add(models, "tree", "b", transformed(capsule_tree_mesh(), stretched));
    return models;
}

struct BuiltIndex {
    TemporaryFolder folder;
    fs::path file = folder.path() / "built.ossuary";

    BuiltIndex() {
        const fs::path models = folder.path() / "models";
        fs::create_directory(models);
        ranking::Classification classes;
        for (const BuiltModel& model : built_models()) {
            write_file(models / (model.name + ".off"), model.off);
            if (classes.classes.empty() || classes.classes.back().name != model.class_name) {
                classes.classes.push_back({model.class_name, "", {}});
            }
            classes.classes.back().models.push_back(model.name);
        }
        index_folder(file, models, classes);
    }
};

}  // namespace

const std::vector<BuiltModel>& built_models() {
    static const std::vector<BuiltModel> models = build_models();
    return models;
}

fs::path copy_of_built_index(const fs::path& folder) {
    static const BuiltIndex built;
    fs::copy_file(built.file, folder / "test.ossuary");
    return folder / "test.ossuary";
}

void index_model(const fs::path& index, const std::string& name, const std::string& off) {
    const fs::path folder = index.parent_path() / ("more-" + name);
    fs::create_directory(folder);
    write_file(folder / (name + ".off"), off);
    index_folder(index, folder, {});
}

TestServer::TestServer(const fs::path& index, const Change& change) {
    server::ServerOptions options;
    options.index = index;
    options.port = 0;
    options.http.threads = 8;
    options.log.level = "off";
    if (change) change(options);
    auto opened = server::Server::open(options);
    if (!opened) throw std::runtime_error(opened.error().message);
    server_ = *std::move(opened);
    runner_ = std::thread([this] { EXPECT_TRUE(server_->run()); });
}

TestServer::~TestServer() { stop(); }

void TestServer::stop() {
    if (!runner_.joinable()) return;
    server_->stop();
    runner_.join();
}

nlohmann::json TestServer::json(std::string_view bytes, int status) const {
    const RawAnswer answer = ask(bytes);
    EXPECT_EQ(answer.status, status) << bytes.substr(0, 80) << "\n" << answer.body.substr(0, 500);
    EXPECT_FALSE(answer.header("X-Request-Id").empty());
    auto json = nlohmann::json::parse(answer.body, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << answer.body.substr(0, 500);
    if (status >= 400) {
        EXPECT_EQ(answer.header("Content-Type"), "application/problem+json");
        EXPECT_EQ(json.value("request_id", ""), answer.header("X-Request-Id"));
        EXPECT_EQ(json.value("status", 0), status);
        EXPECT_FALSE(json.value("detail", "").empty());
    }
    return json;
}

std::string TestServer::code(std::string_view bytes, int status) const {
    return json(bytes, status).value("code", "");
}

}  // namespace ossuary::test
