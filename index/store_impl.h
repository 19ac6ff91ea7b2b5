#pragma once

#include <memory>
#include <string>

#include "engine/core/mutex.h"
#include "index/store.h"
#include "index/store_checksum.h"
#include "index/store_connection.h"
#include "index/store_index_file.h"

// Private to the store.

namespace ossuary::index {

struct Store::Impl {
    Impl(const std::filesystem::path& path, Access access);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    const std::filesystem::path path;
    const Access access;
    IndexParameters parameters;
    int version = 0;
    bool follows = false;  ///< opens the file that takes the place of the one it had
    int busy_timeout_ms = kBusyTimeoutMs;
    const std::shared_ptr<IndexFile> file;
    std::unique_ptr<Connection> connection;  ///< guarded by the file's gate
    Mutex mutex;

    /// Runs `body` alone, with the file open that stands at the path, and so that no exception
    /// leaves it.
    template <typename Body>
    std::invoke_result_t<Body> locked(Body&& body) {
        const Lock lock(mutex);
        return guarded(path, [&]() -> std::invoke_result_t<Body> {
            for (;;) {
                {
                    const SharedLock in_use(file->gate());
                    if (connection && file->stands()) return body();
                }
                if (const auto opened = open(); !opened) return opened.error();
            }
        });
    }
    /// Commits, and makes sure that what was written is in the file that stands at the path:
    /// nothing is acknowledged that went into one which had just been replaced.
    Result<void> commit(SQLite::Transaction& transaction);

    /// Of the file, within `locked`.
    [[nodiscard]] std::uint64_t replacements() const {
        file->is_in_use();
        return file->replacements();
    }

    SQLite::Statement& statement(const std::string& sql) { return connection->statement(sql); }
    SQLite::Database& database() { return connection->database(); }

    /// The checksums of the rows of `table` that fit `where`, due after each change.
    template <typename Value>
    void seal(std::string_view table, std::string_view where, const Value& value) {
        Query(statement(seal_rows(table, where))).bind(value).run();
    }

    Error was_replaced() const {
        return {ErrorCode::kIndexReplaced,
                path.string() + ": was removed or replaced while it was being worked on"};
    }
    Error no_model(ModelId id) const {
        return {ErrorCode::kModelNotFound, "there is no model " + std::to_string(id)};
    }
    /// Puts the place into the message of a decoder.
    Error damaged(ModelId id, const Error& error) const {
        return {error.code, path.string() + ": model " + std::to_string(id) + ": " + error.message};
    }

private:
    /// Opens the file that stands at the path, unless it is open. Errors: also index_replaced.
    Result<void> open();
};

/// The columns that `summary_from` reads, in its order.
inline constexpr std::string_view kSummaryColumns =
    "id, path, name, class, content_hash, vertices, faces, nodes, branches, min_x, min_y, min_z, "
    "max_x, max_y, max_z, surface_area, warnings, indexed_at";
inline constexpr int kSummaryColumnCount = 18;

/// What `select_summaries` adds to them: how the model stands, and what its file says.
inline constexpr std::string_view kStandingColumns =
    "(SELECT up FROM orientations WHERE model = models.id), "
    "(SELECT said_by FROM orientations WHERE model = models.id), "
    "(SELECT metres_per_unit FROM file_frames WHERE model = models.id), "
    "(SELECT up FROM file_frames WHERE model = models.id)";

/// The summary in the first columns of the current row. Errors: index_corrupt.
Result<ModelSummary> summary_from(const Query& query);

/// The summary in the current row of `select_summaries`. Errors: index_corrupt.
Result<ModelSummary> selected_summary(const Query& query);

/// "SELECT <summary columns>, <standing columns> FROM models <rest>"
std::string select_summaries(std::string_view rest);

/// A model's descriptor from the three blobs, with its derived data. Errors: index_corrupt.
Result<descriptor::ModelDescriptor> descriptor_from(std::string_view skeleton,
                                                    std::string_view globals,
                                                    std::string_view signature);

/// The revisions that a reader follows. Errors: index_corrupt.
Result<CollectionState> read_state(Store::Impl& impl);

/// How an upload came to its end: as a model, or in an error.
struct UploadOutcome {
    ModelId model = 0;
    std::optional<Error> error;
};
/// Records the end of an upload, as part of a transaction, and forgets its bytes and the oldest of
/// the finished ones. Errors: index_replaced when it is not, or not any more, the claimant's.
Result<void> finish_upload(Store::Impl& impl, const UploadClaim& claim,
                           const UploadOutcome& outcome);

/// The parameters that are stored in the index. Errors: index_corrupt.
Result<IndexParameters> read_parameters(Connection& connection, const std::filesystem::path& path);

}  // namespace ossuary::index
