#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "index/store.h"
#include "index/store_connection.h"

// Private to the store.

namespace ossuary::index {

struct Store::Impl {
    std::filesystem::path path;
    IndexParameters parameters;
    std::unique_ptr<Connection> connection;
    std::mutex mutex;

    /// Runs `body` alone, and so that no exception leaves it.
    template <typename Body>
    std::invoke_result_t<Body> locked(Body&& body) {
        const std::lock_guard lock(mutex);
        return guarded(path, std::forward<Body>(body));
    }
    SQLite::Statement& statement(const std::string& sql) { return connection->statement(sql); }
    SQLite::Database& database() { return connection->database(); }

    Error no_model(ModelId id) const {
        return {ErrorCode::kModelNotFound,
                path.string() + ": no model with id " + std::to_string(id)};
    }
    /// Puts the place into the message of a decoder.
    Error damaged(ModelId id, const Error& error) const {
        return {error.code, path.string() + ": model " + std::to_string(id) + ": " + error.message};
    }
};

/// The columns that `summary_from` reads, in its order.
inline constexpr std::string_view kSummaryColumns =
    "id, path, name, class, content_hash, vertices, faces, nodes, branches, min_x, min_y, min_z, "
    "max_x, max_y, max_z, surface_area, warnings, indexed_at";
inline constexpr int kSummaryColumnCount = 18;

/// What `select_summaries` adds to them.
inline constexpr std::string_view kOrientationColumns =
    "(SELECT up FROM orientations WHERE model = models.id), "
    "(SELECT said_by FROM orientations WHERE model = models.id)";

/// The summary in the first columns of the current row. Errors: index_corrupt.
Result<ModelSummary> summary_from(const Query& query);

/// The summary in the current row of `select_summaries`. Errors: index_corrupt.
Result<ModelSummary> selected_summary(const Query& query);

/// "SELECT <summary columns>, <orientation columns> FROM models <rest>"
std::string select_summaries(std::string_view rest);

/// A model's descriptor from the three blobs, with its derived data. Errors: index_corrupt.
Result<descriptor::ModelDescriptor> descriptor_from(std::string_view skeleton,
                                                    std::string_view globals,
                                                    std::string_view signature);

/// The revisions that a reader follows. Errors: index_corrupt.
Result<CollectionState> read_state(Store::Impl& impl);

/// The parameters that are stored in the index. Errors: index_corrupt.
Result<IndexParameters> read_parameters(Connection& connection, const std::filesystem::path& path);

}  // namespace ossuary::index
