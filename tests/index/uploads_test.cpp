// Uploads that an index has accepted: nothing is lost, nothing is done for ever.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "index/process_mark.h"
#include "index/store.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

/// The mark of a process that has ended.
std::string mark_of_the_dead() {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        const std::string mark = process_mark();
        _exit(write(ends[1], mark.data(), mark.size()) > 0 ? 0 : 1);
    }
    close(ends[1]);
    std::string mark(200, '\0');
    const ssize_t length = read(ends[0], mark.data(), mark.size());
    close(ends[0]);
    EXPECT_GT(length, 0);
    EXPECT_EQ(waitpid(child, nullptr, 0), child);
    mark.resize(static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
    return mark;
}

TEST(ProcessMark, TellsRunningProcessesFromEndedOnes) {
    EXPECT_TRUE(process_runs(process_mark()));
    EXPECT_NE(process_mark(), process_mark());
    EXPECT_FALSE(process_runs(mark_of_the_dead()));
    std::string other_boot = process_mark();
    other_boot[0] = other_boot[0] == '0' ? '1' : '0';
    EXPECT_FALSE(process_runs(other_boot));
    for (const char* mark : {"", " ", "x", "a b c d", "a ../self 3 1"}) {
        EXPECT_FALSE(process_runs(mark)) << mark;
    }
}

class Uploads : public testing::Test {
protected:
    Store open() {
        auto store = Store::create_or_open(path_, {});
        EXPECT_TRUE(store) << store.error().message;
        return *std::move(store);
    }
    static UploadId add(Store& store, const std::string& name, const std::string& bytes = "bytes") {
        const auto id = store.add_upload({bytes, name, "class"}, {});
        EXPECT_TRUE(id && *id);
        return id && *id ? **id : 0;
    }
    static ClaimedUpload claim(Store& store, const std::string& mark) {
        auto claimed = store.claim_upload(mark);
        EXPECT_TRUE(claimed && *claimed);
        return claimed && *claimed ? **std::move(claimed) : ClaimedUpload{};
    }
    static Result<std::vector<ModelId>> finish(Store& store, const UploadClaim& claim,
                                               std::uint64_t seed) {
        const Change change = PutUpload{claim, test::sample_model(seed, "")};
        return store.apply({&change, 1});
    }
    static Result<std::vector<ModelId>> fail(Store& store, const UploadClaim& claim) {
        const Change change = FailUpload{claim, {ErrorCode::kMeshEmpty, "it has no triangle"}};
        return store.apply({&change, 1});
    }

    test::TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "x.index";
    const std::string mark_ = process_mark();
};

TEST_F(Uploads, WaitInTheIndexUntilTheyAreModels) {
    // More than one piece, with every byte.
    std::string bytes;
    for (int i = 0; i < 17 << 20; ++i) bytes += static_cast<char>(i * 7 + (i >> 8));
    {
        Store store = open();
        EXPECT_EQ(add(store, "first", bytes), 1);
        EXPECT_EQ(add(store, "second"), 2);
        EXPECT_EQ(*store.revision(), 0) << "no model has changed";
    }
    Store store = open();
    EXPECT_EQ(store.upload_queue()->waiting, 2U);
    EXPECT_EQ(store.upload_queue()->waiting_bytes, bytes.size() + 5);
    EXPECT_EQ((*store.upload(1))->state, UploadState::kQueued);
    const ClaimedUpload first = claim(store, mark_);
    EXPECT_EQ(first.claim.id, 1);
    EXPECT_EQ(first.attempt, 1);
    EXPECT_EQ(first.model.name, "first");
    EXPECT_EQ(first.model.class_name, "class");
    EXPECT_TRUE(first.model.bytes == bytes);
    EXPECT_EQ((*store.upload(1))->state, UploadState::kRunning);
    EXPECT_EQ(store.upload_queue()->waiting, 1U);
    const auto models = finish(store, first.claim, 1);
    ASSERT_TRUE(models) << models.error().message;
    const auto done = *store.upload(1);
    EXPECT_EQ(done->state, UploadState::kDone);
    EXPECT_EQ(done->model, models->front());
    EXPECT_TRUE(store.model(done->model));

    ASSERT_TRUE(fail(store, claim(store, mark_).claim));
    const auto failed = *store.upload(2);
    EXPECT_EQ(failed->state, UploadState::kFailed);
    EXPECT_EQ(failed->code, "mesh_empty");
    EXPECT_EQ(failed->message, "it has no triangle");
    const auto listed = *store.uploads(9);
    ASSERT_EQ(listed.size(), 2U);
    EXPECT_EQ(listed[0].id, 2) << "the newest first";
    EXPECT_EQ(listed[0].code, "mesh_empty");
    EXPECT_EQ(listed[0].name, "second");
    EXPECT_EQ(listed[1].state, UploadState::kDone);
    EXPECT_EQ(listed[1].class_name, "class");
    EXPECT_EQ(listed[1].size, bytes.size());
    EXPECT_FALSE(listed[1].accepted_at.empty());
    EXPECT_FALSE(listed[1].finished_at.empty());
    EXPECT_EQ(store.uploads(1)->size(), 1U);
    EXPECT_FALSE(*store.claim_upload(mark_));
    ASSERT_TRUE(store.put_statistics({{1.0}}, *store.revision()));
    test::expect_sound(store);
}

TEST_F(Uploads, HaveNumbersThatAreNeverGivenTwice) {
    { EXPECT_EQ(add(*std::make_unique<Store>(open()), "a"), 1); }
    Store store = open();
    ASSERT_TRUE(fail(store, claim(store, mark_).claim));
    test::execute_sql(path_, "DELETE FROM uploads");
    EXPECT_FALSE(*store.upload(1));
    EXPECT_EQ(add(store, "b"), 2);
}

TEST_F(Uploads, AreTakenOverFromAProgramThatHasEnded) {
    Store store = open();
    add(store, "a");
    for (int attempt = 1; attempt <= 3; ++attempt) {
        EXPECT_EQ(claim(store, mark_of_the_dead()).attempt, attempt);
        EXPECT_EQ((*store.upload(1))->state, UploadState::kQueued) << "nobody works on it";
    }
    EXPECT_EQ(claim(store, mark_).attempt, 4);
    EXPECT_EQ((*store.upload(1))->state, UploadState::kRunning);
    EXPECT_EQ(claim(store, mark_).attempt, 4) << "asked again, not begun again";
}

TEST_F(Uploads, BelongToOneProgramAtATime) {
    Store store = open();
    Store other = open();
    const std::string other_mark = process_mark();
    add(store, "a");
    add(store, "b");
    const ClaimedUpload first = claim(store, mark_);
    const ClaimedUpload second = claim(other, other_mark);
    EXPECT_EQ(first.claim.id, 1);
    EXPECT_EQ(second.claim.id, 2);
    ASSERT_TRUE(fail(other, second.claim));
    EXPECT_FALSE(*other.claim_upload(other_mark));
    const auto stolen = finish(other, {first.claim.id, other_mark}, 1);
    ASSERT_FALSE(stolen);
    EXPECT_EQ(stolen.error().code, ErrorCode::kIndexReplaced);
    EXPECT_EQ(other.models()->total, 0U) << "not even the model";
    EXPECT_TRUE(finish(store, first.claim, 1));
    EXPECT_FALSE(finish(store, first.claim, 2)) << "finished already";
}

TEST_F(Uploads, GoBackToTheirPlaceWhenReleased) {
    Store store = open();
    add(store, "a");
    add(store, "b");
    for (int round = 0; round < 5; ++round) {
        const ClaimedUpload claimed = claim(store, mark_);
        EXPECT_EQ(claimed.claim.id, 1);
        EXPECT_EQ(claimed.attempt, 1) << "what was released counts for nothing";
        ASSERT_TRUE(store.release_upload(claimed.claim));
        EXPECT_EQ((*store.upload(1))->state, UploadState::kQueued);
    }
}

TEST_F(Uploads, AreRefusedWhenTooManyWait) {
    Store store = open();
    const UploadLimits limits{.waiting = 3, .waiting_bytes = 10};
    const auto added = [&](const std::string& bytes) {
        const auto id = store.add_upload({bytes, "x", ""}, limits);
        EXPECT_TRUE(id) << id.error().message;
        return id->has_value();
    };
    EXPECT_TRUE(added(std::string(20, 'x'))) << "alone it may be large";
    EXPECT_FALSE(added("1"));
    const ClaimedUpload large = claim(store, mark_);
    EXPECT_TRUE(added("12345"));
    EXPECT_TRUE(added("123"));
    EXPECT_FALSE(added("123")) << "too many bytes";
    EXPECT_TRUE(added("1"));
    EXPECT_FALSE(added("1")) << "too many uploads";
}

TEST_F(Uploads, AreRememberedForAWhile) {
    Store store = open();
    test::execute_sql(path_,
                      "WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " +
                          std::to_string(kRememberedUploads + 5) +
                          ") INSERT INTO uploads (name, class, content_hash, size, state, code, "
                          "message, accepted_at) SELECT 'x', '', '" +
                          std::string(32, '0') +
                          "', 1, CASE WHEN i = 2 THEN 'queued' ELSE 'failed' END, 'mesh_empty', "
                          "'', '' FROM n");
    const UploadId last = add(store, "last");
    ASSERT_TRUE(fail(store, claim(store, mark_).claim));
    ASSERT_TRUE(fail(store, claim(store, mark_).claim));
    EXPECT_EQ((*store.upload(last))->state, UploadState::kFailed);
    EXPECT_TRUE(*store.upload(last - static_cast<UploadId>(kRememberedUploads) + 1));
    EXPECT_FALSE(*store.upload(last - static_cast<UploadId>(kRememberedUploads)));
}

TEST_F(Uploads, KeepTheirBytesAndWhatWasSaidOfThem) {
    Store store = open();
    const std::string mark = "ossuary-upload 1\n";
    std::vector<UploadedModel> uploads = {
        {"bytes", "plain", "", {}},       {"bytes", "threshold", "", {-1e-300, {}}},
        {"", "label", "", {{}, 0.1}},     {mark + "label 3\nbytes", "like what is kept", "", {}},
        {mark, "cut off", "", {{}, 3.0}},
    };
    for (const UploadedModel& upload : uploads) ASSERT_TRUE(store.add_upload(upload, {}));
    test::expect_sound(store);
    for (const UploadedModel& upload : uploads) {
        const ClaimedUpload claimed = claim(store, mark_);
        EXPECT_EQ(claimed.model.name, upload.name);
        EXPECT_EQ(claimed.model.bytes, upload.bytes) << upload.name;
        EXPECT_EQ(claimed.model.inside, upload.inside) << upload.name;
        ASSERT_TRUE(fail(store, claimed.claim));
    }
}

TEST_F(Uploads, ThatAreDamagedAreFoundByVerify) {
    Store store = open();
    add(store, "waiting", "some bytes");
    add(store, "done");
    for (const char* sql : {
             "UPDATE upload_pieces SET bytes = x'00' WHERE upload = 1",
             "UPDATE upload_pieces SET bytes = x'736f6d6520427974657f' WHERE upload = 1",
             "DELETE FROM upload_pieces WHERE upload = 1",
             "UPDATE uploads SET name = 'Waiting' WHERE id = 1",
             "UPDATE uploads SET class = 'x' WHERE id = 1",
             "UPDATE uploads SET state = 'failed' WHERE id = 1",
         }) {
        test::TemporaryFolder folder;
        const fs::path copy = folder.path() / "copy.index";
        ASSERT_TRUE(store.checkpoint());
        test::execute_sql(path_, "VACUUM INTO '" + copy.string() + "'");
        test::execute_sql(copy, sql);
        const auto report = Store::open(copy, Access::kReadOnly)->verify();
        ASSERT_TRUE(report) << sql;
        EXPECT_EQ(report->uploads, 2U);
        EXPECT_FALSE(report->findings.empty()) << sql;
        test::seal_again(copy);
        const bool text_alone = std::string_view(sql).find("'Waiting'") != std::string::npos ||
                                std::string_view(sql).find("class") != std::string::npos;
        EXPECT_EQ(Store::open(copy, Access::kReadOnly)->verify()->findings.empty(), text_alone)
            << sql;
    }
    test::expect_sound(store);
}

}  // namespace
}  // namespace ossuary::index
