#include "index/store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "index/codec.h"
#include "index/content_hash.h"
#include "index/snapshot.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

class StoreTest : public testing::Test {
protected:
    Store make(const IndexParameters& parameters = {}) {
        auto store = Store::create_or_open(path_, parameters);
        EXPECT_TRUE(store) << store.error().message;
        return *std::move(store);
    }

    test::TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "models.index";
};

TEST_F(StoreTest, GivesBackWhatWasPut) {
    Store store = make();
    const NewModel model = test::sample_model(5, "/m/elephant.off");
    const auto id = store.put(model);
    ASSERT_TRUE(id) << id.error().message;
    EXPECT_EQ(*id, 1);

    const auto summary = store.model(*id);
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->name, "elephant");
    EXPECT_EQ(summary->class_name, "class2");
    EXPECT_EQ(summary->path, "/m/elephant.off");
    EXPECT_EQ(summary->content_hash, model.summary.content_hash);
    EXPECT_EQ(summary->vertices, model.summary.vertices);
    EXPECT_EQ(summary->faces, model.summary.faces);
    EXPECT_EQ(summary->nodes, model.skeleton.nodes.size());
    EXPECT_EQ(summary->branches, model.skeleton.branches.size());
    EXPECT_EQ(summary->bounds.min(), model.summary.bounds.min());
    EXPECT_EQ(summary->bounds.max(), model.summary.bounds.max());
    EXPECT_EQ(summary->surface_area, model.summary.surface_area);
    EXPECT_EQ(summary->frame, model.summary.frame);
    ASSERT_EQ(summary->warnings.size(), 1U);
    EXPECT_EQ(summary->warnings[0].message, model.summary.warnings[0].message);
    EXPECT_EQ(summary->indexed_at.size(), std::string("2026-01-01T00:00:00Z").size());

    const auto skeleton = store.skeleton(*id);
    ASSERT_TRUE(skeleton);
    EXPECT_EQ(encode_skeleton(skeleton->graph), encode_skeleton(model.skeleton));
    ASSERT_EQ(skeleton->chain_codes.size(), model.descriptor.skeleton.branches.size());
    EXPECT_EQ(skeleton->chain_codes[0], model.descriptor.skeleton.branches[0].chain_code);
    EXPECT_EQ(store.preview(*id)->triangles, model.preview.triangles);
    EXPECT_EQ(store.preview(*id)->colours, model.preview.colours);
    const auto segments = store.segments(*id);
    ASSERT_TRUE(segments && *segments);
    EXPECT_EQ(encode_segments(**segments), encode_segments(*model.segments));
    EXPECT_EQ((*segments)->parts[0].triangles, 2U);
    EXPECT_EQ(*store.thumbnail(*id), model.thumbnail);
    const std::vector<ModelId> ids = {*id};
    const auto descriptors = store.descriptors(ids);
    ASSERT_TRUE(descriptors);
    ASSERT_EQ(descriptors->size(), 1U);
    const descriptor::ModelDescriptor& descriptor = descriptors->front().descriptor;
    EXPECT_EQ(encode_descriptor(descriptor.skeleton), encode_descriptor(model.descriptor.skeleton));
    EXPECT_EQ(descriptor.skeleton.rooted.content_key, model.descriptor.skeleton.rooted.content_key);
    EXPECT_EQ(encode_globals(descriptor.globals), encode_globals(model.descriptor.globals));
    EXPECT_EQ(descriptor.signature, model.descriptor.signature);
    EXPECT_EQ(descriptors->front().changed_at, 1);
    EXPECT_EQ(store.models_named("elephant")->size(), 1U);
    EXPECT_TRUE(store.models_named("Elephant")->empty());
}

TEST_F(StoreTest, KeepsTheIdOfAModelWhosePathGetsOtherContents) {
    Store store = make();
    ASSERT_EQ(*store.put(test::sample_model(1, "/m/a.off")), 1);
    ASSERT_EQ(*store.put(test::sample_model(2, "/m/b.off")), 2);
    ASSERT_EQ(*store.put(test::sample_model(3, "/m/a.off")), 1);
    EXPECT_EQ(store.models()->total, 2U);
    EXPECT_EQ(store.model(1)->content_hash, test::sample_model(3, "").summary.content_hash);
    ASSERT_TRUE(store.put_statistics({{1.0}}, *store.revision()));
    test::expect_sound(store);
}

TEST_F(StoreTest, NeverUsesAnIdTwice) {
    Store store = make();
    ASSERT_EQ(*store.put(test::sample_model(1, "/m/a.off")), 1);
    ASSERT_EQ(*store.put(test::sample_model(2, "/m/b.off")), 2);
    ASSERT_TRUE(store.remove(2));
    EXPECT_EQ(*store.put(test::sample_model(3, "/m/c.off")), 3);
}

TEST_F(StoreTest, TakesTheSameUploadOnce) {
    Store store = make();
    const ModelId id = *store.put(test::sample_model(1, ""));
    EXPECT_EQ(*store.put(test::sample_model(1, "")), id);
    EXPECT_NE(*store.put(test::sample_model(2, "")), id);
    EXPECT_TRUE(store.model(id)->path.empty());
    // A file with the same bytes is a model of its own.
    EXPECT_NE(*store.put(test::sample_model(1, "/m/a.off")), id);
}

TEST_F(StoreTest, RemovesAModelWithAllItsParts) {
    Store store = make();
    const ModelId id = *store.put(test::sample_model(1, "/m/a.off"));
    ASSERT_TRUE(store.remove(id));
    EXPECT_EQ(store.model(id).error().code, ErrorCode::kModelNotFound);
    EXPECT_EQ(store.skeleton(id).error().code, ErrorCode::kModelNotFound);
    EXPECT_EQ(store.preview(id).error().code, ErrorCode::kModelNotFound);
    EXPECT_EQ(store.segments(id).error().code, ErrorCode::kModelNotFound);
    EXPECT_EQ(store.thumbnail(id).error().code, ErrorCode::kModelNotFound);
    EXPECT_EQ(store.remove(id).error().code, ErrorCode::kModelNotFound);
    for (const char* table : {"signatures", "descriptors", "skeletons", "branches", "previews",
                              "segments", "thumbnails"}) {
        EXPECT_EQ(test::index_text(path_).find(std::string("== ") + table + "\nmodel"),
                  std::string::npos)
            << table;
    }
}

TEST_F(StoreTest, AppliesAllChangesOrNone) {
    Store store = make();
    const std::vector<Change> changes = {PutModel{test::sample_model(1, "/m/a.off")},
                                         RemoveModel{77}};
    const auto applied = store.apply(changes);
    ASSERT_FALSE(applied);
    EXPECT_EQ(applied.error().code, ErrorCode::kModelNotFound);
    EXPECT_EQ(store.models()->total, 0U);
    EXPECT_EQ(*store.revision(), 0);
}

TEST_F(StoreTest, CountsOneRevisionATransaction) {
    Store store = make();
    EXPECT_EQ(*store.revision(), 0);
    const std::vector<Change> changes = {PutModel{test::sample_model(1, "/m/a.off")},
                                         PutModel{test::sample_model(2, "/m/b.off")}};
    ASSERT_TRUE(store.apply(changes));
    EXPECT_EQ(*store.revision(), 1);
    ASSERT_TRUE(store.apply(changes));  // nothing new
    EXPECT_EQ(*store.revision(), 1);
    const std::vector<Change> failure = {
        RecordFailure{"/m/c.off", content_hash("c"), {ErrorCode::kOffTruncated, "line 3"}}};
    ASSERT_TRUE(store.apply(failure));
    EXPECT_EQ(*store.revision(), 1) << "models did not change";
    ASSERT_TRUE(store.remove(1));
    EXPECT_EQ(*store.revision(), 2);
}

TEST_F(StoreTest, RefusesDescriptionsThatCouldNotBeRead) {
    Store store = make();
    NewModel model = test::sample_model(1, "/m/a.off");
    model.descriptor.signature[0] = std::nanf("");
    const auto put = store.put(model);
    ASSERT_FALSE(put);
    EXPECT_EQ(put.error().code, ErrorCode::kInternal);
    NewModel short_of_labels = test::sample_model(2, "/m/b.off");
    short_of_labels.segments->labels = {0, 1};
    const auto put_short = store.put(short_of_labels);
    ASSERT_FALSE(put_short);
    EXPECT_EQ(put_short.error().code, ErrorCode::kInternal);
    EXPECT_EQ(store.models()->total, 0U);
}

TEST_F(StoreTest, PagesThroughFilteredModels) {
    Store store = make();
    for (std::uint64_t seed = 1; seed <= 9; ++seed) {
        const std::string name =
            "/m/" + std::string(seed % 2 == 0 ? "Cow" : "bull") + std::to_string(seed) + ".off";
        ASSERT_TRUE(store.put(test::sample_model(seed, name)));
    }
    std::vector<ModelId> seen;
    ModelFilter filter;
    filter.limit = 3;
    filter.name_contains = "cOw";
    while (true) {
        const auto page = store.models(filter);
        ASSERT_TRUE(page);
        EXPECT_EQ(page->total, 4U);
        for (const auto& model : page->models) seen.push_back(model.id);
        if (!page->next) break;
        filter.after = *page->next;
    }
    EXPECT_EQ(seen, (std::vector<ModelId>{2, 4, 6, 8}));
    ModelFilter of_class;
    of_class.class_name = "class1";
    EXPECT_EQ(store.models(of_class)->total, 3U);
    of_class.class_name = "";
    EXPECT_EQ(store.models(of_class)->total, 3U) << "models without a class";
}

TEST_F(StoreTest, SaysWhatIsToBeDoneForAFile) {
    Store store = make();
    const NewModel model = test::sample_model(1, "/m/a.off");
    const std::string& hash = model.summary.content_hash;
    EXPECT_EQ(store.claim_work("/m/a.off", hash)->kind, Work::Kind::kDescribe);
    const ModelId id = *store.put(model);
    const auto unchanged = store.claim_work("/m/a.off", hash);
    EXPECT_EQ(unchanged->kind, Work::Kind::kUnchanged);
    EXPECT_EQ(unchanged->models.front().id, id);
    EXPECT_EQ(store.claim_work("/m/a.off", content_hash("else"))->kind, Work::Kind::kDescribe);
    const auto same = store.claim_work("/m/b.off", hash);
    EXPECT_EQ(same->kind, Work::Kind::kSameContent);
    EXPECT_EQ(same->models.front().path, "/m/a.off");

    const std::string bad = content_hash("bad");
    const std::vector<Change> failure = {
        RecordFailure{"/m/c.off", bad, {ErrorCode::kOffTruncated, "line 3"}}};
    ASSERT_TRUE(store.apply(failure));
    const auto known = store.claim_work("/m/c.off", bad);
    EXPECT_EQ(known->kind, Work::Kind::kKnownFailure);
    EXPECT_EQ(known->failure->code, "off_truncated");
    EXPECT_EQ(store.claim_work("/m/c.off", content_hash("mended"))->kind, Work::Kind::kDescribe);
}

TEST_F(StoreTest, ForgetsAFailureOnceTheFileIsIndexed) {
    Store store = make();
    const std::vector<Change> failure = {
        RecordFailure{"/m/a.off", content_hash("bad"), {ErrorCode::kOffTruncated, "line 3"}}};
    ASSERT_TRUE(store.apply(failure));
    ASSERT_EQ(store.failures()->size(), 1U);
    EXPECT_EQ(store.failures()->front().message, "line 3");
    ASSERT_TRUE(store.put(test::sample_model(1, "/m/a.off")));
    EXPECT_TRUE(store.failures()->empty());
}

TEST_F(StoreTest, DropsAModelWhoseNewContentsFail) {
    Store store = make();
    const NewModel model = test::sample_model(1, "/m/a.off");
    const ModelId id = *store.put(model);
    const std::vector<Change> unreadable = {
        RecordFailure{"/m/a.off", "", {ErrorCode::kFileUnreadable, "no"}}};
    ASSERT_TRUE(store.apply(unreadable));
    EXPECT_TRUE(store.model(id)) << "what could not be read may not have changed";
    const std::vector<Change> broken = {
        RecordFailure{"/m/a.off", content_hash("broken"), {ErrorCode::kOffTruncated, "no"}}};
    ASSERT_TRUE(store.apply(broken));
    EXPECT_FALSE(store.model(id));
}

TEST_F(StoreTest, MovesAModelOntoThePathOfAnother) {
    Store store = make();
    ASSERT_TRUE(store.put(test::sample_model(1, "/m/a.off")));
    ASSERT_TRUE(store.put(test::sample_model(2, "/m/b.off")));
    const std::vector<Change> move = {MoveModel{2, "/m/a.off", "a", std::nullopt}};
    ASSERT_TRUE(store.apply(move));
    EXPECT_EQ(store.models()->total, 1U);
    EXPECT_EQ(store.model(2)->path, "/m/a.off");
    EXPECT_EQ(store.model(2)->class_name, "class2");
}

TEST_F(StoreTest, KeepsStatisticsAndEvaluations) {
    Store store = make();
    ASSERT_TRUE(store.put(test::sample_model(1, "/m/a.off")));
    EXPECT_FALSE(store.statistics()->has_value());
    EXPECT_EQ(store.collection_state()->statistics, -1);
    ASSERT_TRUE(store.put_statistics({{1.0, 2.5}}, 1));
    EXPECT_EQ((*store.statistics())->statistics.values, (std::vector<double>{1.0, 2.5}));
    ASSERT_TRUE(store.put_statistics({{9.0}}, 0));
    EXPECT_EQ((*store.statistics())->statistics.values.size(), 2U) << "older ones do not win";
    EXPECT_EQ(store.collection_state()->statistics, 1);

    const EvaluationKey key{1, ranking::RankerKind::kSkeleton, true, 0.15, content_hash("x")};
    EXPECT_FALSE(store.evaluation(key)->has_value());
    const ranking::RetrievalReport report = test::sample_report(3);
    ASSERT_TRUE(store.put_evaluation(key, report));
    const auto kept = store.evaluation(key);
    ASSERT_TRUE(kept->has_value());
    EXPECT_EQ(encode_report((*kept)->report), encode_report(report));
    EXPECT_EQ(store.evaluations()->size(), 1U);
    EvaluationKey other = key;
    other.pose = 0.2;
    EXPECT_FALSE(store.evaluation(other)->has_value());

    ASSERT_TRUE(store.remove(1));
    EXPECT_TRUE(store.evaluations()->empty()) << "of an earlier revision";
    other.revision = 2;
    ASSERT_TRUE(store.put_evaluation(other, report));
    EXPECT_FALSE(store.evaluation(key)->has_value()) << "dropped when another was kept";
}

TEST_F(StoreTest, RefusesOtherParameters) {
    { make({.resolution = 64}); }
    const auto other = Store::create_or_open(path_, {.resolution = 96});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::kIndexParameters);
    EXPECT_NE(other.error().message.find("resolution 64"), std::string::npos);
    EXPECT_TRUE(Store::create_or_open(path_, {.resolution = 64}));
    EXPECT_EQ(Store::open(path_, Access::kReadOnly)->parameters().resolution, 64);
}

TEST_F(StoreTest, ReadersCannotWrite) {
    { make(); }
    auto reader = Store::open(path_, Access::kReadOnly);
    ASSERT_TRUE(reader);
    const auto put = reader->put(test::sample_model(1, "/m/a.off"));
    ASSERT_FALSE(put);
    EXPECT_EQ(put.error().code, ErrorCode::kIndexIo);
}

TEST_F(StoreTest, ReadersSeeWholeTransactionsWhileAnotherConnectionWrites) {
    Store writer = make();
    auto reader = Store::open(path_, Access::kReadOnly);
    ASSERT_TRUE(reader);
    std::atomic<bool> done = false;
    std::thread writing([&] {
        for (std::uint64_t i = 0; i < 60; ++i) {
            const std::vector<Change> pair = {
                PutModel{test::sample_model(2 * i, "/m/" + std::to_string(2 * i) + ".off")},
                PutModel{
                    test::sample_model(2 * i + 1, "/m/" + std::to_string(2 * i + 1) + ".off")}};
            EXPECT_TRUE(writer.apply(pair));
        }
        done = true;
    });
    std::shared_ptr<const Snapshot> snapshot;
    Revision last = 0;
    while (!done) {
        const auto loaded = Snapshot::load(*reader, snapshot.get());
        ASSERT_TRUE(loaded) << loaded.error().message;
        snapshot = *loaded;
        EXPECT_GE(snapshot->revision(), last);
        last = snapshot->revision();
        EXPECT_EQ(snapshot->size(), 2 * static_cast<std::size_t>(last));
    }
    writing.join();
    const auto loaded = Snapshot::load(*reader, snapshot.get());
    EXPECT_EQ((*loaded)->size(), 120U);
}

TEST_F(StoreTest, SaysSoWhenAnotherHoldsTheWriteLockForTooLong) {
    Store store = make();
    ASSERT_TRUE(store.put(test::sample_model(1, "/m/a.off")));
    ASSERT_TRUE(store.set_busy_timeout(50));
    const test::HeldWriteLock lock(path_);
    const auto put = store.put(test::sample_model(2, "/m/b.off"));
    ASSERT_FALSE(put);
    EXPECT_EQ(put.error().code, ErrorCode::kIndexBusy);
    EXPECT_EQ(store.models()->total, 1U) << "reading goes on";
}

const ScanBlock* block_at(const Snapshot& snapshot, std::size_t position) {
    const ScanBlock* found = nullptr;
    snapshot.for_each_block([&](const ScanBlock& block, std::size_t first) {
        if (position >= first && position < first + block.size()) found = &block;
    });
    return found;
}

TEST_F(StoreTest, SnapshotsShareWhatHasNotChanged) {
    Store store = make();
    std::vector<Change> changes;
    for (std::uint64_t seed = 0; seed < 2 * kScanBlockModels; ++seed) {
        changes.push_back(
            PutModel{test::sample_model(seed, "/m/" + std::to_string(seed) + ".off")});
    }
    ASSERT_TRUE(store.apply(changes));
    const auto first = *Snapshot::load(store);
    ASSERT_TRUE(store.put(test::sample_model(1001, "/m/200.off")));
    ASSERT_TRUE(store.put(test::sample_model(1002, "/m/new.off")));
    ASSERT_TRUE(store.remove(201));
    const auto second = *Snapshot::load(store, first.get());
    const auto fresh = *Snapshot::load(store);
    ASSERT_EQ(second->size(), 2 * kScanBlockModels);
    ASSERT_EQ(fresh->size(), second->size());
    EXPECT_EQ(block_at(*second, 0), block_at(*first, 0)) << "shared, not copied";
    EXPECT_NE(block_at(*second, 200), block_at(*first, 200));
    EXPECT_EQ(second->find(201), std::nullopt);
    EXPECT_EQ(second->find(202), 200U);
    for (std::size_t i = 0; i < fresh->size(); ++i) {
        EXPECT_EQ(second->id(i), fresh->id(i));
        EXPECT_EQ(second->changed_at(i), fresh->changed_at(i));
        EXPECT_EQ(second->class_name(i), fresh->class_name(i));
        EXPECT_EQ(second->measures(i), fresh->measures(i));
        const auto row = second->preselection().row(static_cast<std::uint32_t>(i));
        const auto same = fresh->preselection().row(static_cast<std::uint32_t>(i));
        EXPECT_EQ(row.key, same.key);
        EXPECT_TRUE(std::equal(row.signature.begin(), row.signature.end(), same.signature.begin()));
    }
    EXPECT_EQ(first->size(), 2 * kScanBlockModels) << "the earlier one stays as it was";
    EXPECT_EQ(first->find(201), 200U);
}

TEST_F(StoreTest, ASnapshotKnowsClassesAndCopies) {
    Store store = make();
    NewModel model = test::sample_model(1, "/m/a.off");
    ASSERT_TRUE(store.put(model));
    ASSERT_TRUE(store.put(test::sample_model(2, "/m/b.off")));
    model.summary.path = "/m/copy.stl";
    model.summary.content_hash = content_hash("the same mesh in another file");
    ASSERT_TRUE(store.put(model));
    const auto snapshot = *Snapshot::load(store);
    EXPECT_EQ(snapshot->of_class("class1"), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_TRUE(snapshot->of_class("none").empty());
    EXPECT_EQ(snapshot->count_measures({snapshot->measures(0), snapshot->measures(1)}),
              (std::vector<std::size_t>{2, 1}));
    const std::vector<Change> changes = {ClassifyModel{1, "other"}};
    ASSERT_TRUE(store.apply(changes));
    const auto later = *Snapshot::load(store, snapshot.get());
    EXPECT_EQ(later->of_class("other"), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(later->measures(0), snapshot->measures(0));
    EXPECT_EQ(later->preselection().row(0).key, snapshot->preselection().row(0).key);
    ASSERT_TRUE(store.put_statistics({{1.0}}, *store.revision()));
    test::expect_sound(store);
}

TEST_F(StoreTest, ASnapshotFindsTheFoldersOfItsModels) {
    Store store = make();
    std::uint64_t seed = 0;
    for (const char* path : {"/srv/a/x/1.off", "/srv/a/y/2.off", "/home/eva/3.off", "/4.off",
                             "/home/eva/models.zip#in/5.off", ""}) {
        ASSERT_TRUE(store.put(test::sample_model(++seed, path)));
    }
    const auto snapshot = *Snapshot::load(store);
    const ModelRoots& roots = snapshot->roots();
    EXPECT_EQ(roots.relative("/srv/a/y/2.off"), "a/y/2.off");
    EXPECT_EQ(roots.relative("/home/eva/3.off"), "eva/3.off");
    EXPECT_EQ(roots.relative("/4.off"), "4.off");
}

TEST_F(StoreTest, IsOneFileOnceItIsClosed) {
    {
        Store store = make();
        ASSERT_TRUE(store.put(test::sample_model(1, "/m/a.off")));
    }
    EXPECT_FALSE(fs::exists(path_.string() + "-wal"));
    const fs::path copy = folder_.path() / "copy with ? and %41 # in it.index";
    fs::copy_file(path_, copy);
    for (const Access access : {Access::kReadOnly, Access::kInspect, Access::kReadWrite}) {
        const std::string before = test::read_file(copy);
        {
            auto store = Store::open(copy, access);
            ASSERT_TRUE(store) << store.error().message;
            EXPECT_EQ(store->models()->total, 1U);
            EXPECT_TRUE(fs::exists(copy.string() + "-wal")) << "while it is open";
        }
        EXPECT_FALSE(fs::exists(copy.string() + "-wal"));
        EXPECT_FALSE(fs::exists(copy.string() + "-shm"));
        EXPECT_TRUE(test::read_file(copy) == before);
    }
}

TEST_F(StoreTest, ReadersFoldInTheLogOfAProgramThatWasKilled) {
    {
        Store store = make();
        ASSERT_TRUE(store.put(test::sample_model(1, "/m/a.off")));
        ASSERT_TRUE(store.put_statistics({{1.0}}, *store.revision()));
    }
    test::leave_log_behind(path_, "UPDATE models SET name = 'late'");
    ASSERT_GT(fs::file_size(path_.string() + "-wal"), 0U);
    const std::string log = test::read_file(path_.string() + "-wal");
    const std::string before = test::read_file(path_);
    {
        auto store = Store::open(path_, Access::kInspect);
        ASSERT_TRUE(store);
        EXPECT_EQ(store->model(1)->name, "late");
        test::expect_sound(*store);
    }
    EXPECT_TRUE(test::read_file(path_) == before) << "an inspection leaves all as it is";
    EXPECT_TRUE(test::read_file(path_.string() + "-wal") == log);
    {
        auto store = Store::open(path_, Access::kReadOnly);
        ASSERT_TRUE(store);
        EXPECT_EQ(store->model(1)->name, "late");
    }
    EXPECT_FALSE(fs::exists(path_.string() + "-wal"));
    EXPECT_FALSE(fs::exists(path_.string() + "-shm"));
    EXPECT_EQ(Store::open(path_, Access::kReadOnly)->model(1)->name, "late");
}

}  // namespace
}  // namespace ossuary::index
