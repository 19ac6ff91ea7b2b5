// Accepted uploads: what becomes of them whatever describing them brings about.

#include "server/jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "index/process_mark.h"
#include "tests/index/sample_index.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using index::UploadState;

class Jobs : public testing::Test {
protected:
    index::Store open() {
        auto store = index::Store::create_or_open(path_, {});
        EXPECT_TRUE(store) << store.error().message;
        return *std::move(store);
    }
    std::unique_ptr<server::Jobs> start(server::Jobs::Describe describe,
                                        double model_timeout_seconds = 600.0) {
        server::Jobs::Limits limits;
        limits.model_timeout_seconds = model_timeout_seconds;
        return std::make_unique<server::Jobs>(
            open(), limits, log_, metrics_,
            [this](bool removed) { ++(removed ? told_of_removed_ : told_of_added_); },
            std::move(describe));
    }
    static index::UploadId add(server::Jobs& jobs, const std::string& name) {
        const auto id = jobs.add({name + " bytes", name, ""});
        EXPECT_TRUE(id && *id);
        return id && *id ? **id : 0;
    }
    index::UploadRecord finished(index::UploadId id) {
        index::UploadRecord record;
        for (int i = 0; i < 6000; ++i) {
            const auto found = store_.upload(id);
            EXPECT_TRUE(found && *found);
            if (!found || !*found) break;
            record = **found;
            if (record.state == UploadState::kDone || record.state == UploadState::kFailed) break;
            std::this_thread::sleep_for(5ms);
        }
        return record;
    }
    /// A model that follows from the upload's name.
    static Result<index::NewModel> sample(const index::UploadedModel& upload,
                                          const index::IndexParameters&, std::stop_token) {
        auto model = sample_model(std::hash<std::string>()(upload.name), "");
        model.summary.name = upload.name;
        return model;
    }

    TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "x.index";
    server::Log log_{{.level = "off", .json = false}};
    server::Metrics metrics_;
    std::atomic<int> told_of_added_ = 0, told_of_removed_ = 0;  // by two threads
    index::Store store_ = open();
};

TEST_F(Jobs, AreDoneInTheirOrder) {
    auto jobs = start(sample);
    const auto first = add(*jobs, "a");
    const auto second = add(*jobs, "b");
    EXPECT_EQ(finished(second).state, UploadState::kDone);
    EXPECT_LT(finished(first).model, finished(second).model);
    EXPECT_EQ(store_.model(finished(second).model)->name, "b");
    EXPECT_TRUE(jobs->remove(finished(first).model));
    jobs.reset();
    EXPECT_EQ(told_of_added_, 2);
    EXPECT_EQ(told_of_removed_, 1);
}

TEST_F(Jobs, SurviveWhateverDescribingThrows) {
    const auto jobs = start([](const auto& upload, const auto& parameters, auto stop) {
        if (upload.name == "memory") throw std::bad_alloc();
        if (upload.name == "fault") throw std::out_of_range("vector::at");
        return sample(upload, parameters, stop);
    });
    const auto memory = add(*jobs, "memory");
    const auto fault = add(*jobs, "fault");
    const auto good = add(*jobs, "good");
    EXPECT_EQ(finished(memory).code, "out_of_memory");
    EXPECT_EQ(finished(fault).code, "internal");
    EXPECT_NE(finished(fault).message.find("vector::at"), std::string::npos);
    EXPECT_EQ(finished(good).state, UploadState::kDone);
}

TEST_F(Jobs, ThatCannotBeStoredFail) {
    const auto jobs = start([](const auto& upload, const auto& parameters, auto stop) {
        auto model = sample(upload, parameters, stop);
        if (upload.name == "bad") model->descriptor.signature[0] = std::nanf("");
        return model;
    });
    const auto bad = add(*jobs, "bad");
    const auto good = add(*jobs, "good");
    EXPECT_EQ(finished(bad).code, "internal");
    EXPECT_EQ(finished(good).state, UploadState::kDone);
}

TEST_F(Jobs, EndWithTheirTime) {
    const auto jobs = start(
        [](const auto& upload, const auto& parameters, auto stop) -> Result<index::NewModel> {
            if (upload.name != "endless") return sample(upload, parameters, stop);
            while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
            return {ErrorCode::kCancelled, "stopped"};
        },
        0.05);
    const auto endless = add(*jobs, "endless");
    const auto good = add(*jobs, "good");
    EXPECT_EQ(finished(endless).code, "cancelled");
    EXPECT_NE(finished(endless).message.find("took longer than"), std::string::npos);
    EXPECT_EQ(finished(good).state, UploadState::kDone);
}

TEST_F(Jobs, AreLeftToTheNextServer) {
    std::atomic<int> begun = 0;
    auto jobs = start([&](const auto&, const auto&, auto stop) -> Result<index::NewModel> {
        ++begun;
        while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
        return {ErrorCode::kCancelled, "stopped"};
    });
    const auto first = add(*jobs, "a");
    const auto second = add(*jobs, "b");
    while (begun == 0) std::this_thread::sleep_for(1ms);
    EXPECT_EQ((*store_.upload(first))->state, UploadState::kRunning);
    jobs.reset();
    EXPECT_EQ(begun, 1);
    EXPECT_EQ((*store_.upload(first))->state, UploadState::kQueued);
    EXPECT_EQ((*store_.upload(second))->state, UploadState::kQueued);
    jobs = start(sample);
    EXPECT_EQ(finished(first).state, UploadState::kDone);
    EXPECT_EQ(finished(second).state, UploadState::kDone);
    EXPECT_EQ(add(*jobs, "c"), second + 1);
}

TEST_F(Jobs, OfAServerThatEndedAreTakenOver) {
    ASSERT_TRUE(store_.add_upload({"bytes", "left", ""}, {}));
    const auto jobs = start(sample);
    EXPECT_EQ(finished(1).state, UploadState::kDone);
    // By another server, while this one has nothing to do.
    ASSERT_TRUE(store_.add_upload({"bytes", "later", ""}, {}));
    EXPECT_EQ(finished(2).state, UploadState::kDone);
}

TEST_F(Jobs, ThatEndServersAreGivenUp) {
    ASSERT_TRUE(store_.add_upload({"bytes", "poison", ""}, {}));
    // Marks of other boots of the machine: their processes have ended.
    for (int attempt = 0; attempt < 3; ++attempt) {
        ASSERT_TRUE(store_.claim_upload("boot 1 1 " + std::to_string(attempt)));
    }
    std::atomic<int> begun = 0;
    const auto jobs = start([&](const auto& upload, const auto& parameters, auto stop) {
        ++begun;
        return sample(upload, parameters, stop);
    });
    EXPECT_EQ(finished(1).code, "upload_abandoned");
    EXPECT_EQ(begun, 0) << "not even once more";
    EXPECT_EQ(finished(add(*jobs, "good")).state, UploadState::kDone);
}

TEST_F(Jobs, WaitWhileTheIndexCannotBeWritten) {
    ASSERT_TRUE(store_.add_upload({"bytes", "a", ""}, {}));
    index::Store short_of_patience = open();
    ASSERT_TRUE(short_of_patience.set_busy_timeout(20));
    auto lock = std::make_unique<HeldWriteLock>(path_);
    const server::Jobs jobs(
        std::move(short_of_patience), {}, log_, metrics_, [](bool) {}, sample);
    EXPECT_EQ((*store_.upload(1))->state, UploadState::kQueued);
    lock.reset();
    EXPECT_EQ(finished(1).state, UploadState::kDone);
}

TEST_F(Jobs, AreRefusedWhenTooManyWait) {
    server::Jobs::Limits limits;
    limits.waiting.waiting = 1;
    server::Jobs jobs(
        open(), limits, log_, metrics_, [](bool) {},
        [](const auto&, const auto&, auto stop) -> Result<index::NewModel> {
            while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
            return {ErrorCode::kCancelled, "stopped"};
        });
    int taken = 0;
    while (true) {
        const auto id = jobs.add({"bytes " + std::to_string(taken), "x", ""});
        ASSERT_TRUE(id);
        if (!*id) break;
        ++taken;
        ASSERT_LE(taken, 2) << "one waits, one is under way";
    }
    EXPECT_GE(taken, 1);
}

}  // namespace
}  // namespace ossuary::test
