// Files that change between runs, or in the middle of one.

#include <gtest/gtest.h>

#include "engine/core/whole_file.h"
#include "engine/mesh/write_mesh.h"
#include "index/companion_hash.h"
#include "index/indexer.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

/// Hears of failures, and does something once there is a list of files.
class Meddler : public ProgressSink {
public:
    explicit Meddler(std::function<void()> meddle = {}) : meddle_(std::move(meddle)) {}
    void found(const FoundFiles&) override {
        if (meddle_) meddle_();
    }
    void failed(const Failure& failure) override { failures.push_back(failure); }

    std::vector<Failure> failures;

private:
    std::function<void()> meddle_;
};

class ChangingFiles : public testing::Test {
protected:
    Result<IndexOutcome> index(ProgressSink& sink, bool split = false) {
        auto store = Store::create_or_open(folder_.path() / "x.ossuary", {.resolution = 24});
        EXPECT_TRUE(store);
        IndexOptions options;
        options.paths = {models_};
        options.jobs = 1;
        options.reader = &reader_;
        options.split = split;
        return index_models(*store, options, sink);
    }
    Result<IndexOutcome> index() {
        Meddler quiet;
        return index(quiet);
    }
    void write(const std::string& name, const std::string& bytes) {
        ASSERT_TRUE(write_whole_file(models_ / name, bytes));
    }
    static std::string off(const mesh::TriangleMesh& mesh) { return mesh::to_off(mesh); }

    void SetUp() override { fs::create_directory(models_); }

    test::TemporaryFolder folder_;
    fs::path models_ = folder_.path() / "models";
    ModelReader reader_;
};

TEST(ReferredFiles, AreThoseOfTheDocumentsNumbers) {
    using Names = std::vector<std::string>;
    const auto in = [](const std::string& buffers) {
        return referred_files(R"({"asset":{"version":"2.0"},"buffers":[)" + buffers + "]}");
    };
    EXPECT_EQ(in(R"({"uri":"a.bin","byteLength":3},{ "uri" : "b/c%20d.bin" },{"uri":"a.bin"})"),
              (Names{"a.bin", "b/c d.bin"}));
    EXPECT_EQ(in(R"({"uri":"q\u0041\/\"x.bin"})"), Names{"qA/\"x.bin"});
    EXPECT_EQ(in(R"({"uri":"data:application/octet-stream;base64,AA=="},{"uri":"a.PNG"})"),
              Names{});
    EXPECT_EQ(in(R"({"name":"uri"},{"uri":3},{"uri")"), Names{});
    EXPECT_EQ(referred_files("OFF \"uri\":\"a.bin\""), Names{});
    EXPECT_EQ(referred_files(""), Names{});
    EXPECT_EQ(referred_files("glTF"), Names{});
    std::string glb = "glTF" + std::string(16, '\0') + R"({"buffers":[{"uri":"a.bin"}]})";
    glb[12] = static_cast<char>(glb.size() - 20);
    EXPECT_EQ(referred_files(glb), Names{"a.bin"});
}

TEST_F(ChangingFiles, AreIndexedAnewWhereOnlyWhatTheyReferToHasChanged) {
    const auto tree = test::to_separate_gltf(test::capsule_tree_mesh(), "numbers%20of%20it.bin");
    const auto larger =
        test::to_separate_gltf(test::capsule_tree_mesh(2.0), "numbers%20of%20it.bin");
    ASSERT_EQ(tree.document, larger.document);
    write("tree.gltf", tree.document);
    auto outcome = index();
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->failed, 1u);
    write("numbers of it.bin", tree.buffer);
    outcome = index();
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->indexed, 1u);
    EXPECT_EQ(index()->unchanged, 1u);
    write("numbers of it.bin", larger.buffer);
    EXPECT_EQ(index()->indexed, 1u);
    EXPECT_EQ(index()->unchanged, 1u);
}

/// Two nodes of one mesh.
std::string with_two_nodes(std::string document) {
    const auto replace = [&](const std::string& from, const std::string& to) {
        document.replace(document.find(from), from.size(), to);
    };
    replace(R"("nodes":[0])", R"("nodes":[0,1])");
    replace(R"("nodes":[{"mesh":0}])",
            R"("nodes":[{"mesh":0,"name":"one"},{"mesh":0,"name":"two","translation":[50,0,0]}])");
    return document;
}

TEST_F(ChangingFiles, AreToldApartByWhatTheyReferToAlsoWhereTheyAreSplit) {
    for (const auto& [folder, scale] : {std::pair("a", 1.0), std::pair("b", 2.0)}) {
        fs::create_directory(models_ / folder);
        // The same words, whatever is in the buffer.
        const auto gltf = test::to_separate_gltf(test::capsule_tree_mesh(scale), "scene.bin");
        write(std::string(folder) + "/scene.gltf", with_two_nodes(gltf.document));
        write(std::string(folder) + "/scene.bin", gltf.buffer);
    }
    Meddler quiet;
    EXPECT_EQ(index(quiet, true)->indexed, 4u);
    EXPECT_EQ(index(quiet, true)->unchanged, 4u);
    auto store = Store::open(folder_.path() / "x.ossuary", Access::kReadOnly);
    ASSERT_TRUE(store);
    const auto page = store->models({});
    ASSERT_TRUE(page);
    ASSERT_EQ(page->models.size(), 4u);
    const auto length = [&](std::size_t i) { return page->models[i].bounds.diagonal().norm(); };
    EXPECT_NEAR(length(1), length(0), 1e-3);
    EXPECT_NEAR(length(2), 2 * length(0), 1e-3);
    EXPECT_NEAR(length(3), 2 * length(0), 1e-3);
}

TEST_F(ChangingFiles, OfAnArchiveThatIsRewrittenMeanwhileAreLeftForTheNextRun) {
    const fs::path archive = models_ / "toys.zip";
    const std::string tree = off(test::capsule_tree_mesh());
    const std::string ring = off(test::torus_mesh(2.0, 0.5));
    test::write_zip(archive, {{"a.off", tree}, {"b.off", ring}});
    Meddler meddler([&] { test::write_zip(archive, {{"a.off", ring}, {"c.off", tree}}); });
    const auto outcome = index(meddler);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->indexed, 0u);
    ASSERT_EQ(meddler.failures.size(), 2u);
    for (const Failure& failure : meddler.failures) {
        EXPECT_EQ(failure.code, "file_unreadable");
        EXPECT_NE(failure.message.find("written to"), std::string::npos) << failure.message;
    }
    const auto next = index();
    ASSERT_TRUE(next);
    EXPECT_EQ(next->indexed, 2u);
    EXPECT_EQ(next->failed + next->known_failures, 0u);
}

}  // namespace
}  // namespace ossuary::index
