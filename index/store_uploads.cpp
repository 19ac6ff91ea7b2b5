// Uploads: a queue in the index, and what became of them.

#include <algorithm>

#include "engine/core/error_code.h"
#include "index/content_hash.h"
#include "index/process_mark.h"
#include "index/store_impl.h"
#include "index/timestamp.h"
#include "index/upload_bytes.h"

namespace ossuary::index {

namespace {

/// Well below the largest value that SQLite takes (a billion bytes).
constexpr std::size_t kPieceSize = 8 << 20;

/// Commits of its scope are on the disk, not only with the system, when they return.
class DurableCommits {
public:
    explicit DurableCommits(SQLite::Database& database) : database_(database) {
        database_.exec("PRAGMA synchronous = FULL");
    }
    DurableCommits(const DurableCommits&) = delete;
    DurableCommits& operator=(const DurableCommits&) = delete;
    ~DurableCommits() { database_.tryExec("PRAGMA synchronous = NORMAL"); }

private:
    SQLite::Database& database_;
};

UploadQueue read_queue(Store::Impl& impl) {
    Query waiting(impl.statement(
        "SELECT count(*), coalesce(sum(size), 0) FROM uploads WHERE state = 'queued'"));
    waiting.step();
    return {static_cast<std::size_t>(waiting.integer(0)),
            static_cast<std::size_t>(waiting.integer(1))};
}

void put_bytes(Store::Impl& impl, UploadId id, std::string_view bytes) {
    for (std::int64_t piece = 0; !bytes.empty(); ++piece) {
        const std::string_view part = bytes.substr(0, kPieceSize);
        bytes.remove_prefix(part.size());
        Query(impl.statement("INSERT INTO upload_pieces (upload, piece, bytes) VALUES (?, ?, ?)"))
            .bind(id, piece, BlobView{part})
            .run();
    }
}

/// The oldest that nobody works on, or that `claimant` has already.
std::optional<UploadId> next_upload(Store::Impl& impl, std::string_view claimant) {
    Query unfinished(impl.statement(
        "SELECT id, state, claimant FROM uploads WHERE state IN ('queued', 'running') "
        "ORDER BY id"));
    while (unfinished.step()) {
        const std::string holder = unfinished.text(2);
        if (unfinished.text(1) == "queued" || holder == claimant || !process_runs(holder)) {
            return unfinished.integer(0);
        }
    }
    return {};
}

/// A claimed upload with its bytes. Errors: index_corrupt.
Result<ClaimedUpload> read_claimed(Store::Impl& impl, UploadId id) {
    ClaimedUpload claimed;
    Query row(impl.statement(
        "SELECT claimant, attempts, name, class, content_hash FROM uploads WHERE id = ?"));
    row.bind(id).step();
    claimed.claim = {id, row.text(0)};
    claimed.attempt = static_cast<int>(row.integer(1));
    claimed.model.name = row.text(2);
    claimed.model.class_name = row.text(3);
    Query pieces(impl.statement("SELECT bytes FROM upload_pieces WHERE upload = ? ORDER BY piece"));
    pieces.bind(id);
    std::string bytes;
    while (pieces.step()) bytes += pieces.blob(0);
    take_stored_bytes(std::move(bytes), claimed.model);
    return claimed;
}

UploadState parse_state(std::string_view text, std::string_view claimant) {
    if (text == "done") return UploadState::kDone;
    if (text == "failed") return UploadState::kFailed;
    const bool running = text == "running" && process_runs(claimant);
    return running ? UploadState::kRunning : UploadState::kQueued;
}

constexpr std::string_view kSelectUploads =
    "SELECT id, state, claimant, model, code, message, name, class, size, accepted_at, finished_at "
    "FROM uploads ";

UploadRecord record_from(const Query& row) {
    UploadRecord record;
    record.id = row.integer(0);
    record.state = parse_state(row.text(1), row.text(2));
    if (record.state == UploadState::kDone) record.model = row.integer(3);
    if (record.state == UploadState::kFailed) {
        record.code = row.text(4);
        record.message = row.text(5);
    }
    record.name = row.text(6);
    record.class_name = row.text(7);
    record.size = static_cast<std::size_t>(std::max<std::int64_t>(row.integer(8), 0));
    record.accepted_at = row.text(9);
    record.finished_at = row.text(10);
    return record;
}

}  // namespace

Result<std::optional<UploadId>> Store::add_upload(const UploadedModel& upload,
                                                  const UploadLimits& limits) {
    using Added = Result<std::optional<UploadId>>;
    const std::string bytes = stored_bytes(upload);
    return impl_->locked([&]() -> Added {
        const DurableCommits durable(impl_->database());
        SQLite::Transaction transaction(impl_->database(), SQLite::TransactionBehavior::IMMEDIATE);
        const UploadQueue queue = read_queue(*impl_);
        const bool too_many = queue.waiting >= limits.waiting;
        const bool too_large =
            queue.waiting > 0 && queue.waiting_bytes + bytes.size() > limits.waiting_bytes;
        if (too_many || too_large) return std::optional<UploadId>();
        Query(impl_->statement("INSERT INTO uploads (name, class, content_hash, size, state, "
                               "accepted_at) VALUES (?, ?, ?, ?, 'queued', ?)"))
            .bind(upload.name, upload.class_name, content_hash(bytes),
                  static_cast<std::int64_t>(bytes.size()), utc_now())
            .run();
        const UploadId id = impl_->database().getLastInsertRowid();
        impl_->seal("uploads", "id = ?", id);
        put_bytes(*impl_, id, bytes);
        if (const auto committed = impl_->commit(transaction); !committed) {
            return committed.error();
        }
        return std::optional(id);
    });
}

Result<std::optional<ClaimedUpload>> Store::claim_upload(std::string_view claimant) {
    using Claimed = Result<std::optional<ClaimedUpload>>;
    return impl_->locked([&]() -> Claimed {
        // Asked often where nothing waits: only then is it worth to ask for the write lock.
        if (!next_upload(*impl_, claimant)) return std::optional<ClaimedUpload>();
        SQLite::Transaction transaction(impl_->database(), SQLite::TransactionBehavior::IMMEDIATE);
        const auto id = next_upload(*impl_, claimant);
        if (!id) return std::optional<ClaimedUpload>();
        // Who has it already has not ended in its middle.
        Query(impl_->statement("UPDATE uploads SET state = 'running', claimant = ?2, "
                               "attempts = attempts + (claimant <> ?2) WHERE id = ?1"))
            .bind(*id, claimant)
            .run();
        impl_->seal("uploads", "id = ?", *id);
        auto claimed = read_claimed(*impl_, *id);
        if (!claimed) return claimed.error();
        if (const auto committed = impl_->commit(transaction); !committed) {
            return committed.error();
        }
        return std::optional(*std::move(claimed));
    });
}

Result<void> Store::release_upload(const UploadClaim& claim) {
    return impl_->locked([&]() -> Result<void> {
        SQLite::Transaction transaction(impl_->database(), SQLite::TransactionBehavior::IMMEDIATE);
        Query(impl_->statement("UPDATE uploads SET state = 'queued', claimant = '', "
                               "attempts = attempts - 1 "
                               "WHERE id = ? AND state = 'running' AND claimant = ?"))
            .bind(claim.id, claim.claimant)
            .run();
        impl_->seal("uploads", "id = ?", claim.id);
        return impl_->commit(transaction);
    });
}

Result<void> finish_upload(Store::Impl& impl, const UploadClaim& claim,
                           const UploadOutcome& outcome) {
    Query finish(
        impl.statement("UPDATE uploads SET state = ?3, claimant = '', model = ?4, "
                       "code = ?5, message = ?6, finished_at = ?7 "
                       "WHERE id = ?1 AND state = 'running' AND claimant = ?2"));
    if (outcome.error) {
        finish.bind(claim.id, claim.claimant, std::string_view("failed"), nullptr,
                    to_string(outcome.error->code), outcome.error->message, utc_now());
    } else {
        finish.bind(claim.id, claim.claimant, std::string_view("done"), outcome.model, nullptr,
                    nullptr, utc_now());
    }
    if (finish.run() == 0) {
        return {ErrorCode::kIndexReplaced, impl.path.string() + ": upload " +
                                               std::to_string(claim.id) +
                                               " is not this program's to finish any more"};
    }
    impl.seal("uploads", "id = ?", claim.id);
    Query(impl.statement("DELETE FROM upload_pieces WHERE upload = ?")).bind(claim.id).run();
    Query(impl.statement("DELETE FROM uploads WHERE state IN ('done', 'failed') AND id <= "
                         "(SELECT id FROM uploads WHERE state IN ('done', 'failed') "
                         "ORDER BY id DESC LIMIT 1 OFFSET ?)"))
        .bind(static_cast<std::int64_t>(kRememberedUploads))
        .run();
    return {};
}

Result<std::optional<UploadRecord>> Store::upload(UploadId id) {
    using Found = Result<std::optional<UploadRecord>>;
    return impl_->locked([&]() -> Found {
        Query row(impl_->statement(std::string(kSelectUploads) + "WHERE id = ?"));
        if (!row.bind(id).step()) return std::optional<UploadRecord>();
        return std::optional(record_from(row));
    });
}

Result<std::vector<UploadRecord>> Store::uploads(std::size_t most) {
    return impl_->locked([&]() -> Result<std::vector<UploadRecord>> {
        Query rows(impl_->statement(std::string(kSelectUploads) + "ORDER BY id DESC LIMIT ?"));
        rows.bind(static_cast<std::int64_t>(most));
        std::vector<UploadRecord> records;
        while (rows.step()) records.push_back(record_from(rows));
        return records;
    });
}

Result<UploadQueue> Store::upload_queue() {
    return impl_->locked([&]() -> Result<UploadQueue> { return read_queue(*impl_); });
}

}  // namespace ossuary::index
