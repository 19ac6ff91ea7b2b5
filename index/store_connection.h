#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/core/result.h"
#include "index/store.h"

// Private to the store: how SQLite is opened, asked and mistrusted.

namespace ossuary::index {

/// Marks an SQLite file as an index: "OSSY".
inline constexpr std::int32_t kApplicationId = 0x4F535359;

/// An SQLite error as one of ours; `path` is named in the message.
Error store_error(const std::filesystem::path& path, const SQLite::Exception& exception);

/// Runs `body` (which returns a Result) so that no exception leaves it.
template <typename Body>
std::invoke_result_t<Body> guarded(const std::filesystem::path& path, Body&& body) {
    try {
        return body();
    } catch (const SQLite::Exception& exception) {
        return store_error(path, exception);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::kOutOfMemory, path.string() + ": not enough memory"};
    }
}

/// Bytes to bind as a blob; must outlive the query.
struct BlobView {
    std::string_view bytes;
};

/// One use of a prepared statement; gives it back, reset, at the end of its scope.
class Query {
public:
    explicit Query(SQLite::Statement& statement) : statement_(statement) {}
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;
    ~Query() { statement_.tryReset(); }

    /// Binds the values to the parameters from the first on.
    template <typename... Values>
    Query& bind(const Values&... values) {
        int index = 0;
        (bind_one(++index, values), ...);
        return *this;
    }
    /// Binds one value to the parameter with this number, from 1.
    template <typename Value>
    Query& bind_at(int index, const Value& value) {
        bind_one(index, value);
        return *this;
    }
    /// True when there is a (next) row.
    bool step() { return statement_.executeStep(); }
    /// For statements without rows; returns how many rows they changed.
    int run() { return statement_.exec(); }

    [[nodiscard]] bool is_null(int column) const { return statement_.getColumn(column).isNull(); }
    [[nodiscard]] std::int64_t integer(int column) const {
        return statement_.getColumn(column).getInt64();
    }
    [[nodiscard]] double real(int column) const { return statement_.getColumn(column).getDouble(); }
    [[nodiscard]] std::string text(int column) const {
        return statement_.getColumn(column).getString();
    }
    /// Valid until the next step.
    [[nodiscard]] std::string_view blob(int column) const {
        const SQLite::Column value = statement_.getColumn(column);
        const void* bytes = value.getBlob();
        return {static_cast<const char*>(bytes), static_cast<std::size_t>(value.getBytes())};
    }

private:
    void bind_one(int index, std::int64_t value) { statement_.bind(index, value); }
    void bind_one(int index, std::uint32_t value) { statement_.bind(index, value); }
    void bind_one(int index, int value) { statement_.bind(index, value); }
    void bind_one(int index, double value) { statement_.bind(index, value); }
    void bind_one(int index, const std::string& value) { statement_.bind(index, value); }
    void bind_one(int index, std::string_view value) { statement_.bind(index, std::string(value)); }
    void bind_one(int index, const BlobView& value) {
        statement_.bindNoCopy(index, value.bytes.data(), static_cast<int>(value.bytes.size()));
    }
    void bind_one(int index, std::nullptr_t) { statement_.bind(index); }

    SQLite::Statement& statement_;
};

/// How long a write waits for another process's unless a store is told otherwise.
inline constexpr int kBusyTimeoutMs = 10'000;

/// An open database with its prepared statements. Throws SQLite::Exception; see `guarded`.
class Connection {
public:
    Connection(const std::filesystem::path& path, int flags);

    SQLite::Database& database() { return database_; }
    /// A statement, prepared at its first use.
    SQLite::Statement& statement(const std::string& sql);
    /// The single integer that `sql` gives.
    std::int64_t integer(const std::string& sql);

    void set_busy_timeout(int milliseconds);
    /// Writes the log back into the file and empties it, waiting for readers no longer than that;
    /// whether it could. Throws nothing.
    bool fold_log(int timeout_ms);
    /// Whether closing leaves the log as it is, even when nobody else has the file open.
    void keep_log(bool keep);
    /// Whether the file has another name by now, or none.
    bool has_moved();

private:
    SQLite::Database database_;
    int busy_timeout_ms_ = kBusyTimeoutMs;
    std::map<std::string, std::unique_ptr<SQLite::Statement>, std::less<>> statements_;
};

/// Opens an existing index; migrates it if it is older, unless only to inspect it. Waits for a
/// program that uses the log for a file that was here before. Errors as Store::open.
Result<std::unique_ptr<Connection>> open_connection(const std::filesystem::path& path,
                                                    Access access);

/// Makes an index unless there is one.
Result<void> make_index(const std::filesystem::path& path, const IndexParameters& parameters);

}  // namespace ossuary::index
