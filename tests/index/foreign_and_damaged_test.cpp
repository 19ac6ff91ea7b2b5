// What is not an index, is not one any more, or is one of another time.

#include <gtest/gtest.h>

#include <random>

#include "index/codec.h"
#include "index/migrations.h"
#include "index/store.h"
#include "tests/index/sample_index.h"
#include "tests/support/source_folder.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

class ForeignFile : public testing::Test {
protected:
    /// Neither way of opening takes the file, nor touches it.
    void expect_refused(ErrorCode code) {
        const std::string before = fs::is_regular_file(path_) ? test::read_file(path_) : "";
        for (const Access access : {Access::kReadOnly, Access::kReadWrite}) {
            const auto opened = Store::open(path_, access);
            ASSERT_FALSE(opened);
            EXPECT_EQ(opened.error().code, code) << opened.error().message;
            EXPECT_NE(opened.error().message.find(path_.string()), std::string::npos);
        }
        const auto created = Store::create_or_open(path_, {});
        ASSERT_FALSE(created);
        EXPECT_EQ(created.error().code, code) << created.error().message;
        if (fs::is_regular_file(path_)) {
            EXPECT_TRUE(test::read_file(path_) == before);
        }
        EXPECT_FALSE(fs::exists(path_.string() + "-wal"));
        EXPECT_FALSE(fs::exists(path_.string() + "-journal"));
    }

    test::TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "x.index";
};

TEST_F(ForeignFile, TextIsRefusedAndLeftAlone) {
    test::write_file(path_, "OFF\n3 1 0\n");
    expect_refused(ErrorCode::kIndexForeign);
}

TEST_F(ForeignFile, LongBinaryIsRefusedAndLeftAlone) {
    test::write_file(path_, std::string(100'000, '\x7F'));
    expect_refused(ErrorCode::kIndexForeign);
}

TEST_F(ForeignFile, AnotherProgramsDatabaseIsRefusedAndLeftAlone) {
    test::make_database(path_, "CREATE TABLE models (id INTEGER); PRAGMA user_version = 1;");
    expect_refused(ErrorCode::kIndexForeign);
}

TEST_F(ForeignFile, FoldersAreRefused) {
    fs::create_directory(path_);
    expect_refused(ErrorCode::kIndexForeign);
}

TEST_F(ForeignFile, ALaterVersionIsRefusedAndLeftAlone) {
    { ASSERT_TRUE(Store::create_or_open(path_, {})); }
    test::execute_sql(path_, "PRAGMA user_version = " + std::to_string(schema_version() + 1) + ";");
    expect_refused(ErrorCode::kIndexNewer);
}

TEST_F(ForeignFile, AMissingFileIsNotFound) {
    for (const Access access : {Access::kReadOnly, Access::kReadWrite}) {
        const auto opened = Store::open(path_, access);
        ASSERT_FALSE(opened);
        EXPECT_EQ(opened.error().code, ErrorCode::kIndexNotFound);
    }
    EXPECT_FALSE(fs::exists(path_)) << "opening makes nothing";
}

TEST_F(ForeignFile, AnEmptyFileIsNoIndexButMayBecomeOne) {
    test::write_file(path_, "");
    const auto opened = Store::open(path_, Access::kReadWrite);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::kIndexForeign);
    EXPECT_TRUE(Store::create_or_open(path_, {}));
    EXPECT_TRUE(Store::open(path_, Access::kReadOnly));
}

TEST_F(ForeignFile, AMissingFolderIsSaidSo) {
    const auto created = Store::create_or_open(folder_.path() / "none" / "x.index", {});
    ASSERT_FALSE(created);
    EXPECT_EQ(created.error().code, ErrorCode::kIndexIo);
    EXPECT_NE(created.error().message.find("no folder"), std::string::npos);
}

TEST_F(ForeignFile, UnknownParametersAreDamage) {
    { ASSERT_TRUE(Store::create_or_open(path_, {})); }
    for (const char* sql : {"UPDATE parameters SET value = 'sideways' WHERE name = 'thinning'",
                            "UPDATE parameters SET value = '-3' WHERE name = 'resolution'",
                            "INSERT INTO parameters (name, value) VALUES ('colour', 'red')",
                            "DELETE FROM parameters WHERE name = 'pipeline'"}) {
        const std::string whole = test::read_file(path_);
        test::execute_sql(path_, sql);
        const auto opened = Store::open(path_, Access::kReadOnly);
        ASSERT_FALSE(opened) << sql;
        EXPECT_EQ(opened.error().code, ErrorCode::kIndexCorrupt) << sql;
        test::write_file(path_, whole);
    }
}

/// An index with some models, for damaging.
class DamagedIndex : public ForeignFile {
protected:
    void SetUp() override {
        auto store = Store::create_or_open(path_, {});
        ASSERT_TRUE(store);
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            ASSERT_TRUE(
                store->put(test::sample_model(seed, "/m/" + std::to_string(seed) + ".off")));
        }
        ASSERT_TRUE(store->put_statistics({{1.0}}, *store->revision()));
        ASSERT_TRUE(store->put_evaluation(
            {*store->revision(), ranking::RankerKind::kHybrid, false, 0.15, std::string(32, '0')},
            test::sample_report(1)));
    }

    std::vector<Finding> findings() {
        auto store = Store::open(path_, Access::kReadOnly);
        EXPECT_TRUE(store) << store.error().message;
        const auto report = store->verify();
        EXPECT_TRUE(report);
        return report->findings;
    }
};

TEST_F(DamagedIndex, ASoundOneHasNoFindings) {
    auto store = Store::open(path_, Access::kReadOnly);
    const auto report = store->verify();
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->findings.empty());
    EXPECT_EQ(report->models, 6U);
    EXPECT_EQ(report->blobs, 6U * 8U + 3U);
}

TEST_F(DamagedIndex, VerifyFindsEveryKindOfDamage) {
    const std::string whole = test::read_file(path_);
    for (const char* sql : {
             "UPDATE signatures SET signature = substr(signature, 1, 30) WHERE model = 2",
             "UPDATE descriptors SET skeleton = x'00' WHERE model = 2",
             "UPDATE descriptors SET globals = zeroblob(64) WHERE model = 2",
             "UPDATE descriptors SET skeleton = (SELECT skeleton FROM descriptors WHERE model = 3) "
             "WHERE model = 2",
             "UPDATE skeletons SET skeleton = zeroblob(64) WHERE model = 2",
             "UPDATE previews SET mesh = x'4D455348' WHERE model = 2",
             "UPDATE segments SET segments = x'50415254' WHERE model = 2",
             "UPDATE segments SET segments = zeroblob(64) WHERE model = 2",
             "UPDATE surface_features SET features = zeroblob(64) WHERE model = 2",
             "DELETE FROM segments WHERE model = 2",
             "UPDATE thumbnails SET png = x'89504E47' WHERE model = 2",
             "UPDATE branches SET chain_code = '5' WHERE model = 2 AND branch = 0",
             "UPDATE branches SET node_a = 7 WHERE model = 2 AND branch = 0",
             "DELETE FROM branches WHERE model = 2 AND branch = 0",
             "DELETE FROM skeletons WHERE model = 2",
             "DELETE FROM previews WHERE model = 2",
             "DELETE FROM signatures WHERE model = 2",
             "DELETE FROM descriptors WHERE model = 2",
             "UPDATE models SET content_hash = 'no hash, though 32 characters !!' WHERE id = 2",
             "UPDATE models SET warnings = 'none' WHERE id = 2",
             "UPDATE models SET nodes = nodes + 1 WHERE id = 2",
             "UPDATE models SET min_x = 1e9 WHERE id = 2",
             "UPDATE models SET revision = 1000 WHERE id = 2",
             "UPDATE models SET name = '' WHERE id = 2",
             "UPDATE file_frames SET metres_per_unit = 1e999 WHERE model = 2",
             "PRAGMA ignore_check_constraints = 1; UPDATE file_frames SET up = 'w' WHERE model = 2",
             "UPDATE statistics SET statistics = x'00'",
             "UPDATE statistics SET revision = 1000",
             "DELETE FROM statistics",
             "UPDATE evaluations SET report = x'00'",
             "UPDATE evaluations SET ranker = 'dice'",
             "INSERT INTO failures (path, content_hash, code, message, failed_at) "
             "VALUES ('/m/z.off', '', 'bad_luck', '', '')",
             "PRAGMA foreign_keys = OFF; DELETE FROM models WHERE id = 2",
             "DELETE FROM state",
             "DELETE FROM scan_blocks",
             "UPDATE scan_blocks SET models = zeroblob(64)",
             "UPDATE scan_blocks SET revision = 1000",
             "UPDATE signatures SET signature = (SELECT signature FROM signatures WHERE model = 3) "
             "WHERE model = 2",
         }) {
        test::execute_sql(path_, sql);
        test::seal_again(path_);  // not by its checksum alone
        EXPECT_FALSE(findings().empty()) << sql;
        test::write_file(path_, whole);
    }
    EXPECT_TRUE(findings().empty());
}

TEST_F(DamagedIndex, VerifyFindsChangedTextAndNumbersByTheirChecksums) {
    const std::vector<Change> failure = {
        RecordFailure{"/m/z.off", "", {ErrorCode::kFileUnreadable, "no"}}};
    {
        auto store = Store::open(path_, Access::kReadWrite);
        ASSERT_TRUE(store->apply(failure));
        ASSERT_TRUE(store->add_upload({"bytes", "up", "class"}, {}));
    }
    const std::string whole = test::read_file(path_);
    EXPECT_TRUE(findings().empty());
    for (const char* sql : {
             "UPDATE models SET name = 'other' WHERE id = 2",
             "UPDATE models SET path = '/m/other.off' WHERE id = 2",
             "UPDATE models SET path = NULL WHERE id = 2",
             "UPDATE models SET class = 'other' WHERE id = 2",
             "UPDATE models SET warnings = '[]' WHERE id = 2",
             "UPDATE models SET content_hash = CASE substr(content_hash, 1, 1) WHEN '0' THEN '1' "
             "ELSE '0' END || substr(content_hash, 2) WHERE id = 2",
             "UPDATE models SET vertices = vertices + 1 WHERE id = 2",
             "UPDATE models SET max_x = max_x * 1.0000001 WHERE id = 2",
             "UPDATE models SET surface_area = surface_area * 1.0000001 WHERE id = 2",
             "UPDATE models SET indexed_at = '2020-01-01T00:00:00Z' WHERE id = 2",
             "UPDATE models SET revision = 1 WHERE id = 2",
             "UPDATE file_frames SET metres_per_unit = 1 WHERE model = 2",
             "UPDATE file_frames SET up = 'y' WHERE model = 2",
             "UPDATE models SET checksum = checksum + 1 WHERE id = 2",
             "UPDATE models SET checksum = NULL WHERE id = 2",
             "UPDATE failures SET path = '/m/y.off'",
             "UPDATE failures SET message = 'yes'",
             "UPDATE parameters SET value = '95' WHERE name = 'resolution'",
             "UPDATE state SET revision = revision + 1",
             "UPDATE statistics SET revision = revision - 1",
             "UPDATE evaluations SET pose = 0.25",
             "UPDATE evaluations SET computed_at = ''",
             "UPDATE uploads SET name = 'down'",
             "UPDATE uploads SET attempts = 7",
         }) {
        test::execute_sql(path_, sql);
        EXPECT_TRUE(test::read_file(path_) != whole) << sql;
        EXPECT_FALSE(findings().empty()) << sql;
        test::write_file(path_, whole);
    }
}

TEST_F(DamagedIndex, ABlockThatIsDamagedIsMadeAnewWithTheNextChange) {
    test::execute_sql(path_, "UPDATE scan_blocks SET models = zeroblob(64)");
    auto store = Store::open(path_, Access::kReadWrite);
    ASSERT_TRUE(store);
    EXPECT_EQ(store->scan().error().code, ErrorCode::kIndexCorrupt);
    ASSERT_TRUE(store->remove(6));
    const auto scan = store->scan();
    ASSERT_TRUE(scan) << scan.error().message;
    EXPECT_EQ(scan->blocks.front().models->ids, (std::vector<ModelId>{1, 2, 3, 4, 5}));
    test::expect_sound(*store);
}

TEST_F(DamagedIndex, VerifyKnowsTheSchema) {
    const std::string whole = test::read_file(path_);
    for (const char* sql : {
             "DROP INDEX models_by_name",
             "CREATE TABLE notes (text TEXT)",
             "ALTER TABLE failures ADD COLUMN more TEXT",
             "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, "
             "'nodes >= 0', 'nodes >= 1') WHERE name = 'models'",
         }) {
        test::execute_sql(path_, sql);
        EXPECT_FALSE(findings().empty()) << sql;
        test::write_file(path_, whole);
    }
    EXPECT_TRUE(findings().empty());
}

TEST_F(DamagedIndex, VerifyHoldsPartsAgainstPreviewAndSkeleton) {
    const std::string whole = test::read_file(path_);
    NewModel model = test::sample_model(2, "/m/2.off");
    const auto with_segments = [&](const ModelSegments& segments) {
        std::string hex;
        for (const char byte : encode_segments(segments)) {
            constexpr std::string_view kDigits = "0123456789ABCDEF";
            hex += kDigits[static_cast<unsigned char>(byte) >> 4];
            hex += kDigits[static_cast<unsigned char>(byte) & 15];
        }
        test::write_file(path_, whole);
        test::execute_sql(path_, "UPDATE segments SET segments = x'" + hex + "' WHERE model = 2");
        return findings().size();
    };
    EXPECT_EQ(with_segments(*model.segments), 0U);
    ModelSegments longer = *model.segments;
    longer.labels.push_back(0);
    EXPECT_EQ(with_segments(longer), 1U);
    ModelSegments elsewhere = *model.segments;
    elsewhere.parts[0].branch = static_cast<std::int32_t>(model.skeleton.branches.size());
    EXPECT_EQ(with_segments(elsewhere), 1U);
}

TEST_F(DamagedIndex, FlippedBytesGiveErrorsOrFindingsButNoCrash) {
    const std::string whole = test::read_file(path_);
    // Every page, at places that move through the page; the first hundred bytes one by one.
    std::vector<std::size_t> places;
    for (std::size_t at = 0; at < 100; ++at) places.push_back(at);
    for (std::size_t at = 100; at < whole.size(); at += 509) places.push_back(at);
    for (const std::size_t at : places) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        test::write_file(path_, damaged);
        auto store = Store::open(path_, Access::kReadOnly);
        if (!store) continue;
        (void)store->models();
        (void)store->scan();
        (void)store->descriptors(std::vector<ModelId>{1, 2, 3, 4, 5, 6});
        (void)store->listed(1, 6);
        (void)store->loops(1, 6);
        (void)store->evaluations();
        (void)store->features(0, 10);
        for (ModelId id = 1; id <= 6; ++id) {
            (void)store->skeleton(id);
            (void)store->preview(id);
            (void)store->segments(id);
            (void)store->thumbnail(id);
        }
        (void)store->verify();
    }
    test::write_file(path_, whole);
}

TEST_F(DamagedIndex, FlippedBytesThatChangeWhatTheIndexSaysAreFound) {
    const std::string whole = test::read_file(path_);
    const std::string text = test::index_text(path_);
    std::mt19937_64 random(20260101);
    int unseen = 0;
    for (int flip = 0; flip < 300; ++flip) {
        std::string damaged = whole;
        const std::size_t at = random() % whole.size();
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
        test::write_file(path_, damaged);
        auto store = Store::open(path_, Access::kInspect);
        if (!store) continue;
        const auto report = store->verify();
        if (!report || !report->findings.empty()) continue;
        // Space that nothing uses holds nothing.
        ++unseen;
        EXPECT_EQ(test::index_text(path_), text) << "byte " << at;
    }
    EXPECT_LT(unseen, 300);
}

TEST_F(DamagedIndex, TruncatedFilesGiveErrorsOrFindings) {
    const std::string whole = test::read_file(path_);
    const std::string text = test::index_text(path_);
    for (std::size_t length = 1; length < whole.size(); length += 1021) {
        test::write_file(path_, std::string_view(whole).substr(0, length));
        auto store = Store::open(path_, Access::kReadOnly);
        if (!store) continue;
        const auto report = store->verify();
        // The end of the last page may be unused; then nothing is lost.
        const bool noticed = !report || !report->findings.empty();
        EXPECT_TRUE(noticed || test::index_text(path_) == text) << length;
    }
}

/// Every version that an index may have been left at.
class OldVersion : public testing::TestWithParam<int> {};

TEST_P(OldVersion, IsMigratedWithItsModels) {
    test::TemporaryFolder folder;
    const fs::path path = folder.path() / "old.index";
    const NewModel model = test::sample_model(3, "/m/a.off");
    test::make_old_index(path, GetParam(), model);
    {
        auto store = Store::open(path, Access::kReadWrite);
        ASSERT_TRUE(store) << store.error().message;
        EXPECT_EQ(store->version(), schema_version());
        EXPECT_EQ(store->model(1)->name, "a");
        EXPECT_EQ(store->model(1)->frame, FileFrame{});
        const bool turned = GetParam() >= kFirstVersionWithOrientations;
        EXPECT_EQ(store->model(1)->orientation,
                  turned ? (Orientation{Up::kZ, true}) : Orientation{});
        EXPECT_EQ(*store->revision(), 1);
        EXPECT_TRUE(store->put(test::sample_model(4, "/m/b.off")));
        EXPECT_TRUE(store->put_statistics({{1.0}}, *store->revision()));
        test::expect_sound(*store);
    }
    // The schema is then that of an index made today.
    const fs::path fresh = folder.path() / "fresh.index";
    { ASSERT_TRUE(Store::create_or_open(fresh, {})); }
    EXPECT_EQ(test::schema_text(path), test::schema_text(fresh));
}

TEST_P(OldVersion, IsVerifiedAsItStands) {
    test::TemporaryFolder folder;
    const fs::path path = folder.path() / "old.index";
    test::make_old_index(path, GetParam(), test::sample_model(3, "/m/a.off"));
    const std::string before = test::read_file(path);
    const auto findings = [&] {
        auto store = Store::open(path, Access::kInspect);
        EXPECT_TRUE(store) << store.error().message;
        EXPECT_EQ(store->version(), GetParam());
        const auto report = store->verify();
        EXPECT_TRUE(report) << report.error().message;
        EXPECT_EQ(report->version, GetParam());
        EXPECT_EQ(report->models, 1U);
        std::vector<std::string> texts;
        for (const Finding& finding : report->findings) {
            // It was made without.
            if (finding.subject != "statistics") texts.push_back(finding.message);
        }
        return texts;
    };
    EXPECT_EQ(findings(), std::vector<std::string>());
    EXPECT_TRUE(test::read_file(path) == before);
    EXPECT_FALSE(fs::exists(path.string() + "-wal"));
    EXPECT_FALSE(fs::exists(path.string() + "-shm"));
    EXPECT_TRUE(test::read_file(path) == before);
    test::execute_sql(path, "UPDATE skeletons SET skeleton = zeroblob(64)");
    EXPECT_FALSE(findings().empty());
}

TEST_P(OldVersion, IsMigratedForReadersToo) {
    test::TemporaryFolder folder;
    const fs::path path = folder.path() / "old.index";
    test::make_old_index(path, GetParam(), test::sample_model(3, "/m/a.off"));
    auto store = Store::open(path, Access::kReadOnly);
    ASSERT_TRUE(store) << store.error().message;
    EXPECT_EQ(store->models()->total, 1U);
    EXPECT_FALSE(store->statistics()->has_value());
    const auto segments = store->segments(1);
    ASSERT_TRUE(segments) << segments.error().message;
    EXPECT_EQ(segments->has_value(), store->parameters().pipeline >= kFirstPipelineWithSegments);
}

INSTANTIATE_TEST_SUITE_P(Versions, OldVersion, testing::Range(1, schema_version() + 1),
                         [](const auto& each) { return "From" + std::to_string(each.param); });

TEST(Migrations, AreNumberedWithoutGaps) {
    int expected = 0;
    for (const Migration& migration : migrations()) {
        EXPECT_EQ(migration.version, ++expected);
        EXPECT_FALSE(migration.sql.empty());
    }
    EXPECT_GE(expected, 2);
}

TEST(Migrations, AreAllThatTheFolderHolds) {
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(test::source_folder() / "migrations")) {
        if (entry.path().extension() != ".sql") continue;
        ++files;
        const std::string text = test::read_file(entry.path());
        bool embedded = false;
        for (const Migration& migration : migrations()) {
            embedded = embedded ||
                       (migration.name == entry.path().stem().string() && migration.sql == text);
        }
        EXPECT_TRUE(embedded) << entry.path();
    }
    EXPECT_EQ(files, migrations().size());
}

}  // namespace
}  // namespace ossuary::index
