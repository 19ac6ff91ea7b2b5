#include "index/indexer.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <thread>

#include "index/content_hash.h"
#include "index/snapshot.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

constexpr const char* kChildModels = "OSSUARY_TEST_MODELS";
constexpr const char* kChildIndex = "OSSUARY_TEST_INDEX";

/// Remembers what it hears; may ask for a stop after so many models.
class Listener : public ProgressSink {
public:
    void progress(const IndexProgress& progress) override {
        EXPECT_EQ(progress.done, last.done + 1);
        last = progress;
        if (progress.done == stop_after) stop.request_stop();
    }
    void failed(const Failure& failure) override { failures.push_back(failure); }

    IndexProgress last;
    std::vector<Failure> failures;
    std::stop_source stop;
    std::size_t stop_after = 0;
};

class IndexerTest : public testing::Test {
protected:
    Store open() { return open(index_); }
    static Store open(const fs::path& path) {
        auto store = Store::create_or_open(path, test::kCoarse);
        EXPECT_TRUE(store) << store.error().message;
        return *std::move(store);
    }
    IndexOptions options(int jobs = 2) {
        IndexOptions made;
        made.paths = {models_};
        made.jobs = jobs;
        return made;
    }
    IndexOutcome run(Store& store, const IndexOptions& wanted) {
        ProgressSink quiet;
        const auto outcome = index_models(store, wanted, quiet);
        EXPECT_TRUE(outcome) << outcome.error().message;
        return outcome ? *outcome : IndexOutcome{};
    }
    IndexOutcome run(Store& store) { return run(store, options()); }
    /// Names and ids of all models.
    static std::map<std::string, ModelId> ids(Store& store) {
        std::map<std::string, ModelId> found;
        ModelFilter everything;
        everything.limit = 0;
        const auto page = store.models(everything);
        for (const auto& model : page->models) found[model.name] = model.id;
        return found;
    }

    test::TemporaryFolder folder_;
    fs::path models_ = folder_.path() / "models";
    fs::path index_ = folder_.path() / "x.index";
};

TEST_F(IndexerTest, TakesEveryModelInTheOrderOfPathsAndSkipsWhatIsUnchanged) {
    test::write_sample_meshes(models_, 6);
    Store store = open();
    Listener listener;
    const auto first = index_models(store, options(), listener);
    ASSERT_TRUE(first) << first.error().message;
    EXPECT_EQ(first->files, 6U);
    EXPECT_EQ(first->indexed, 6U);
    EXPECT_EQ(first->failed, 0U);
    EXPECT_EQ(listener.last.done, 6U);
    EXPECT_EQ(listener.last.total, 6U);
    EXPECT_EQ(ids(store), (std::map<std::string, ModelId>{{"00_box", 1},
                                                          {"01_tree", 2},
                                                          {"02_torus", 3},
                                                          {"03_box", 4},
                                                          {"04_tree", 5},
                                                          {"05_torus", 6}}));
    test::expect_sound(store);
    const ModelSummary tree = *store.model(2);
    EXPECT_EQ(tree.content_hash, content_hash(test::read_file(models_ / "01_tree.off")));
    EXPECT_GE(tree.branches, 4U);
    EXPECT_GT(tree.surface_area, 0.0);
    EXPECT_LE(store.preview(2)->triangles.size(), 3U * 2000U);
    EXPECT_FALSE(store.thumbnail(2)->empty());
    ASSERT_TRUE(store.statistics()->has_value());
    EXPECT_EQ(store.collection_state()->statistics, first->revision);

    const std::string before = test::index_text(index_);
    const IndexOutcome second = run(store);
    EXPECT_EQ(second.indexed, 0U);
    EXPECT_EQ(second.unchanged, 6U);
    EXPECT_EQ(test::index_text(index_), before) << "nothing is written when nothing is new";
}

TEST_F(IndexerTest, GivesTheSameIndexForEveryNumberOfJobs) {
    test::write_sample_meshes(models_, 10);
    test::write_file(models_ / "04b_bad.off", "OFF\n3 1 0\n0 0 0\n");
    fs::copy_file(models_ / "01_tree.off", models_ / "07b_copy.off");
    {
        Store one = open();
        run(one, options(1));
    }
    const fs::path other = folder_.path() / "other.index";
    {
        Store many = open(other);
        run(many, options(4));
    }
    EXPECT_EQ(test::index_text(index_), test::index_text(other));
}

TEST_F(IndexerTest, RecordsFailuresWithTheirCodesAndGoesOn) {
    test::write_sample_meshes(models_, 2);
    test::write_file(models_ / "00a_truncated.off", "OFF\n3 1 0\n0 0 0\n");
    test::write_file(models_ / "00b_empty.off", "");
    test::write_file(models_ / "00c_faceless.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n");
    test::write_file(models_ / "00d_two_points.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n");
    Store store = open();
    Listener listener;
    const auto outcome = index_models(store, options(), listener);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->indexed, 2U);
    EXPECT_EQ(outcome->failed, 4U);
    EXPECT_EQ(listener.failures.size(), 4U);
    const auto failures = store.failures();
    ASSERT_EQ(failures->size(), 4U);
    EXPECT_EQ((*failures)[0].code, "off_truncated");
    EXPECT_EQ((*failures)[2].code, "mesh_empty");
    EXPECT_EQ((*failures)[3].code, "points_too_few");
    for (const Failure& failure : *failures) {
        EXPECT_TRUE(is_content_hash(failure.content_hash));
        EXPECT_FALSE(failure.message.empty());
    }
    test::expect_sound(store);

    // The same bytes are not tried again unless that is asked for.
    EXPECT_EQ(run(store).known_failures, 4U);
    IndexOptions retry = options();
    retry.retry_failed = true;
    EXPECT_EQ(run(store, retry).failed, 4U);

    // Mended, it is tried again.
    fs::copy_file(models_ / "01_tree.off", models_ / "00b_empty.off",
                  fs::copy_options::overwrite_existing);
    const IndexOutcome mended = run(store);
    EXPECT_EQ(mended.indexed, 1U);
    EXPECT_EQ(mended.known_failures, 3U);
    EXPECT_EQ(store.failures()->size(), 3U);
}

TEST_F(IndexerTest, DescribesAgainWhatHasChangedUnderTheSameId) {
    test::write_sample_meshes(models_, 3);
    Store store = open();
    run(store);
    const auto before = *store.model(2);
    fs::copy_file(models_ / "02_torus.off", models_ / "01_tree.off",
                  fs::copy_options::overwrite_existing);
    const IndexOutcome outcome = run(store);
    EXPECT_EQ(outcome.indexed, 1U);
    EXPECT_EQ(outcome.unchanged, 2U);
    EXPECT_NE(store.model(2)->content_hash, before.content_hash);
    EXPECT_EQ(store.model(2)->content_hash, store.model(3)->content_hash);
    test::expect_sound(store);
}

TEST_F(IndexerTest, KnowsAModelByItsBytesWhenItsFileHasMoved) {
    test::write_sample_meshes(models_, 3);
    Store store = open();
    run(store);
    fs::create_directory(models_ / "sub");
    fs::rename(models_ / "01_tree.off", models_ / "sub" / "oak.off");
    fs::copy_file(models_ / "02_torus.off", models_ / "sub" / "ring.off");
    IndexOptions pruning = options();
    pruning.prune = Prune::kYes;
    const IndexOutcome outcome = run(store, pruning);
    EXPECT_EQ(outcome.moved, 1U);
    EXPECT_EQ(outcome.indexed, 1U) << "a copy is a model of its own";
    EXPECT_EQ(outcome.pruned, 0U);
    EXPECT_EQ(ids(store), (std::map<std::string, ModelId>{
                              {"00_box", 1}, {"oak", 2}, {"02_torus", 3}, {"ring", 4}}));
}

TEST_F(IndexerTest, MovesOneModelToOnePathOnly) {
    test::write_sample_meshes(models_, 2);
    for (const int jobs : {1, 3}) {
        const fs::path path = folder_.path() / ("jobs" + std::to_string(jobs));
        Store store = open(path);
        run(store);
        fs::rename(models_ / "01_tree.off", models_ / "x.off");
        fs::copy_file(models_ / "x.off", models_ / "y.off");
        const IndexOutcome outcome = run(store, options(jobs));
        EXPECT_EQ(outcome.moved, 1U);
        EXPECT_EQ(outcome.indexed, 1U);
        EXPECT_EQ(ids(store), (std::map<std::string, ModelId>{{"00_box", 1}, {"x", 2}, {"y", 3}}));
        fs::rename(models_ / "x.off", models_ / "01_tree.off");
        fs::remove(models_ / "y.off");
    }
}

TEST_F(IndexerTest, PrunesWhatIsGoneUnderThePathsAndNothingElse) {
    test::write_sample_meshes(models_, 3);
    test::write_sample_meshes(folder_.path() / "elsewhere", 2);
    test::write_file(models_ / "bad.off", "OFF\n3 1 0\n");
    Store store = open();
    IndexOptions both = options();
    both.paths.push_back(folder_.path() / "elsewhere");
    run(store, both);
    const ModelId upload = *store.put(test::sample_model(9, ""));
    ASSERT_EQ(store.models()->total, 6U);
    fs::remove(models_ / "00_box.off");
    fs::remove(models_ / "bad.off");
    fs::remove_all(folder_.path() / "elsewhere");

    EXPECT_EQ(run(store).pruned, 0U) << "not asked for";
    EXPECT_EQ(store.models()->total, 6U);
    IndexOptions pruning = options();
    pruning.prune = Prune::kYes;
    const IndexOutcome outcome = run(store, pruning);
    EXPECT_EQ(outcome.pruned, 1U);
    EXPECT_EQ(store.models()->total, 5U) << "what lies elsewhere may only be out of reach";
    EXPECT_TRUE(store.failures()->empty());
    EXPECT_TRUE(store.model(upload)) << "an upload has no file to be gone";
}

TEST_F(IndexerTest, NamesClassesFromAClassification) {
    test::write_sample_meshes(models_, 3);
    fs::rename(models_ / "00_box.off", models_ / "7.off");
    fs::rename(models_ / "01_tree.off", models_ / "m8.off");
    Store store = open();
    IndexOptions classed = options();
    classed.classes =
        *ranking::parse_classification("PSB 1\n2 3\nbox 0 1\n7\ntree 0 2\n8\n9\n", "x.cla");
    run(store, classed);
    EXPECT_EQ(store.models_named("7")->front().class_name, "box");
    EXPECT_EQ(store.models_named("m8")->front().class_name, "tree");
    EXPECT_EQ(store.models_named("02_torus")->front().class_name, "");

    EXPECT_EQ(run(store).classified, 0U);
    EXPECT_EQ(store.models_named("7")->front().class_name, "box") << "kept without --classes";
    classed.classes = *ranking::parse_classification("PSB 1\n1 1\ncube 0 1\n7\n", "x.cla");
    const IndexOutcome renamed = run(store, classed);
    EXPECT_EQ(renamed.classified, 1U);
    EXPECT_EQ(renamed.indexed, 0U);
    EXPECT_EQ(store.models_named("7")->front().class_name, "cube");
    EXPECT_EQ(store.models_named("m8")->front().class_name, "tree");
}

TEST_F(IndexerTest, GoesOnWhereItWasStopped) {
    // Far more than are under way at once when the stop comes.
    constexpr std::size_t kModels = 60;
    test::write_sample_meshes(models_, static_cast<int>(kModels));
    const fs::path straight = folder_.path() / "straight.index";
    IndexOptions small = options();
    small.batch_models = 2;
    {
        Store store = open(straight);
        run(store, small);
    }
    Store store = open();
    Listener listener;
    listener.stop_after = 4;
    const auto stopped = index_models(store, small, listener, listener.stop.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
    const std::size_t kept = store.models()->total;
    EXPECT_GE(kept, 4U);
    EXPECT_LT(kept, kModels);
    const IndexOutcome rest = run(store, small);
    EXPECT_EQ(rest.unchanged, kept);
    EXPECT_EQ(rest.indexed, kModels - kept) << "nothing is done twice";
    test::expect_sound(store);
    EXPECT_EQ(ids(store).size(), kModels);
    EXPECT_EQ(test::without_revisions(test::index_text(index_)),
              test::without_revisions(test::index_text(straight)));
}

// Not a test: what the next test runs as another process and kills.
TEST(IndexerChild, DISABLED_IndexesUntilItIsKilled) {
    const char* models = std::getenv(kChildModels);
    const char* index = std::getenv(kChildIndex);
    ASSERT_TRUE(models != nullptr && index != nullptr);
    auto store = Store::create_or_open(index, test::kCoarse);
    ASSERT_TRUE(store);
    IndexOptions options;
    options.paths = {models};
    options.jobs = 2;
    options.batch_models = 1;
    ProgressSink quiet;
    EXPECT_TRUE(index_models(*store, options, quiet));
}

TEST_F(IndexerTest, GoesOnAfterBeingKilled) {
    test::write_sample_meshes(models_, 12);
    IndexOptions small = options();
    small.batch_models = 1;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        // A program of its own: the threads of this one do not live on in a fork.
        setenv(kChildModels, models_.c_str(), 1);
        setenv(kChildIndex, index_.c_str(), 1);
        execl("/proc/self/exe", "index_test", "--gtest_also_run_disabled_tests",
              "--gtest_filter=IndexerChild.*", nullptr);
        _exit(127);
    }
    // Killed as soon as three models are in.
    std::size_t seen = 0;
    const auto begin = std::chrono::steady_clock::now();
    while (seen < 3 && std::chrono::steady_clock::now() - begin < std::chrono::seconds(120)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        auto reader = Store::open(index_, Access::kReadOnly);
        if (!reader) continue;
        const auto page = reader->models();
        if (page) seen = page->total;
    }
    kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child was through before it could be killed";

    Store store = open();
    const std::size_t kept = store.models()->total;
    EXPECT_GE(kept, 3U);
    const auto before = ids(store);
    const IndexOutcome rest = run(store, small);
    EXPECT_EQ(rest.unchanged, kept);
    EXPECT_EQ(rest.indexed, 12U - kept);
    const auto after = ids(store);
    for (const auto& [name, id] : before) EXPECT_EQ(after.at(name), id);
    EXPECT_EQ(after.size(), 12U);
    EXPECT_EQ(after.rbegin()->second, 12) << "ids as if nothing had happened";
    test::expect_sound(store);
}

TEST_F(IndexerTest, GivesUpOnAModelAfterItsTimeAndGoesOn) {
    test::write_sample_meshes(models_, 2);
    // Fine enough that describing takes far longer than the timer to wake up.
    auto opened = Store::create_or_open(index_, {.resolution = 128});
    ASSERT_TRUE(opened);
    Store store = *std::move(opened);
    IndexOptions hasty = options();
    hasty.model_timeout_seconds = 1e-9;
    const IndexOutcome outcome = run(store, hasty);
    EXPECT_EQ(outcome.failed, 2U);
    const auto failures = store.failures();
    for (const Failure& failure : *failures) {
        EXPECT_EQ(failure.code, "cancelled");
        EXPECT_NE(failure.message.find("longer than"), std::string::npos);
    }
}

TEST_F(IndexerTest, RefusesAPathThatDoesNotExistBeforeAnythingElse) {
    Store store = open();
    IndexOptions wrong = options();
    ProgressSink quiet;
    const auto outcome = index_models(store, wrong, quiet);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::kFileNotFound);
}

TEST_F(IndexerTest, RefusesAnIndexOfAnotherPipeline) {
    { open(); }
    test::execute_sql(index_, "UPDATE parameters SET value = '999' WHERE name = 'pipeline'");
    auto store = Store::open(index_, Access::kReadWrite);
    ASSERT_TRUE(store);
    fs::create_directory(models_);
    ProgressSink quiet;
    const auto outcome = index_models(*store, options(), quiet);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::kIndexParameters);
}

TEST_F(IndexerTest, AddsToAnIndexThatAReaderHasOpen) {
    test::write_sample_meshes(models_, 2);
    Store writer = open();
    run(writer);
    auto reader = Store::open(index_, Access::kReadOnly);
    ASSERT_TRUE(reader);
    const auto before = *Snapshot::load(*reader);
    test::write_sample_meshes(models_, 4);
    run(writer);
    const auto after = *Snapshot::load(*reader, before.get());
    EXPECT_EQ(before->size(), 2U);
    EXPECT_EQ(after->size(), 4U);
    EXPECT_EQ(after->changed_at(0), before->changed_at(0));
    EXPECT_EQ(after->state().statistics, after->revision());
}

TEST_F(IndexerTest, DescribesUploads) {
    test::write_sample_meshes(models_, 2);
    const std::string bytes = test::read_file(models_ / "01_tree.off");
    const auto model = describe_upload({bytes, "my\ntree", "plant"}, test::kCoarse);
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model->summary.name, "mytree");
    EXPECT_EQ(model->summary.class_name, "plant");
    EXPECT_EQ(model->summary.path, "");
    EXPECT_TRUE(model->segments);
    const auto bad = describe_upload({"OFF\n3 1 0\n", "bad", ""}, test::kCoarse);
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().code, ErrorCode::kOffTruncated);
    const auto name_of = [&](const std::string& name) {
        const auto named = describe_upload({bytes, name, ""}, test::kCoarse);
        EXPECT_TRUE(named) << named.error().message;
        return named ? named->summary.name : std::string();
    };
    EXPECT_EQ(name_of(std::string(199, 'a') + "\xC3\xA9"), std::string(199, 'a'))
        << "cut before the character";
    EXPECT_EQ(name_of("b\xE4r\x7F"), "b\xEF\xBF\xBDr");
    EXPECT_EQ(name_of("\n\t"), "model");
}

}  // namespace
}  // namespace ossuary::index
