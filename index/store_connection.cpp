#include "index/store_connection.h"

#include <sqlite3.h>

#include <array>
#include <chrono>
#include <thread>

#include "index/migrations.h"
#include "index/store_checksum.h"
#include "index/store_file.h"
#include "index/store_scan.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

/// How long the file of another program's log is waited for, and how often it is looked at.
constexpr std::chrono::milliseconds kLogTimeout(kBusyTimeoutMs);
constexpr std::chrono::milliseconds kLogInterval(50);

/// A reader's connection. It may write as far as the system is concerned, though nothing ever does:
/// only such a connection can take away the -wal and -shm that it has made, or fold in what another
/// program left, should it be the last to close. On a medium where SQLite cannot keep its -shm file
/// an index is still readable if its log is empty, because then nobody can be writing it.
std::unique_ptr<Connection> open_reader(const fs::path& path) {
    try {
        auto connection = std::make_unique<Connection>(path, SQLite::OPEN_READWRITE);
        connection->database().exec("PRAGMA query_only = ON");
        connection->integer("PRAGMA user_version");
        return connection;
    } catch (const SQLite::Exception& exception) {
        const int code = exception.getErrorCode();
        const bool no_place = code == SQLITE_CANTOPEN || code == SQLITE_READONLY;
        if (!no_place || !log_is_empty(path)) throw;
    }
    return std::make_unique<Connection>(file_uri(path, "?immutable=1"),
                                        SQLite::OPEN_READONLY | SQLite::OPEN_URI);
}

/// Runs what is missing, each migration in its own transaction.
void migrate(Connection& connection) {
    for (const Migration& migration : migrations()) {
        if (connection.integer("PRAGMA user_version") >= migration.version) continue;
        SQLite::Transaction transaction(connection.database(),
                                        SQLite::TransactionBehavior::IMMEDIATE);
        // Another process may have been first.
        if (connection.integer("PRAGMA user_version") >= migration.version) continue;
        connection.database().exec(std::string(migration.sql));
        if (migration.version == kFirstVersionWithUploads) {
            seal_unsealed_rows(connection.database(), migration.version);
        }
        if (migration.version == kFirstVersionWithScan) fill_scan_blocks(connection);
        connection.database().exec("PRAGMA user_version = " + std::to_string(migration.version));
        transaction.commit();
    }
}

/// Everything a new index starts with, in one transaction and in the rollback-journal mode that
/// SQLite starts with: whatever happens, the file is empty or marked as ours.
void initialize(Connection& connection, const IndexParameters& parameters) {
    SQLite::Database& database = connection.database();
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::EXCLUSIVE);
    // Another process may have been first.
    if (connection.integer("PRAGMA application_id") != 0 ||
        connection.integer("SELECT count(*) FROM sqlite_schema") != 0) {
        return;
    }
    database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
    for (const Migration& migration : migrations()) database.exec(std::string(migration.sql));
    database.exec("PRAGMA user_version = " + std::to_string(schema_version()));
    SQLite::Statement insert(database, "INSERT INTO parameters (name, value) VALUES (?, ?)");
    const std::array<std::pair<std::string, std::string>, 3> rows = {{
        {"resolution", std::to_string(parameters.resolution)},
        {"thinning", std::string(to_string(parameters.thinning))},
        {"pipeline", std::to_string(parameters.pipeline)},
    }};
    for (const auto& [name, value] : rows) {
        insert.bind(1, name);
        insert.bind(2, value);
        insert.exec();
        insert.reset();
    }
    seal_unsealed_rows(database, schema_version());
    transaction.commit();
}

}  // namespace

Error store_error(const fs::path& path, const SQLite::Exception& exception) {
    const std::string file = path.string() + ": ";
    const std::string detail = std::string(" (SQLite: ") + exception.what() + ")";
    switch (exception.getErrorCode()) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return {ErrorCode::kIndexBusy,
                    file + "another process has been writing the index for too long" + detail};
        case SQLITE_NOTADB:
        case SQLITE_CORRUPT:
        case SQLITE_ERROR:     // our own statements fail only on a schema that is not ours
        case SQLITE_MISMATCH:  // a value of another type than the schema's
            return {ErrorCode::kIndexCorrupt, file + "the index is damaged" + detail};
        case SQLITE_FULL:
            return {ErrorCode::kIndexIo, file + "no space left to write the index" + detail};
        case SQLITE_READONLY:
        case SQLITE_PERM:
        case SQLITE_AUTH:
            return {ErrorCode::kIndexIo, file + "the index may not be written" + detail};
        case SQLITE_CANTOPEN:
            return {ErrorCode::kIndexIo, file + "the index cannot be opened" + detail};
        case SQLITE_NOMEM:
            return {ErrorCode::kOutOfMemory, file + "not enough memory" + detail};
        case SQLITE_CONSTRAINT:
            return {ErrorCode::kInternal, file + "a constraint of the index failed" + detail};
        default:
            return {ErrorCode::kIndexIo, file + "the index cannot be read or written" + detail};
    }
}

Connection::Connection(const fs::path& path, int flags)
    : database_(path.string(), flags, kBusyTimeoutMs) {
    // An index may come from elsewhere: no code from its schema, and no trust in its pages.
    database_.exec("PRAGMA trusted_schema = OFF");
    database_.exec("PRAGMA cell_size_check = ON");
    database_.exec("PRAGMA foreign_keys = ON");
    // In WAL mode a crash of the machine may lose the last transactions but never damages.
    database_.exec("PRAGMA synchronous = NORMAL");
    add_checksum_function(database_);
}

SQLite::Statement& Connection::statement(const std::string& sql) {
    auto found = statements_.find(sql);
    if (found == statements_.end()) {
        found = statements_.emplace(sql, std::make_unique<SQLite::Statement>(database_, sql)).first;
    }
    return *found->second;
}

std::int64_t Connection::integer(const std::string& sql) {
    SQLite::Statement statement(database_, sql);
    return statement.executeStep() ? statement.getColumn(0).getInt64() : 0;
}

void Connection::set_busy_timeout(int milliseconds) {
    database_.setBusyTimeout(milliseconds);
    busy_timeout_ms_ = milliseconds;
}

bool Connection::fold_log(int timeout_ms) {
    sqlite3* handle = database_.getHandle();
    sqlite3_busy_timeout(handle, timeout_ms);
    const int outcome =
        sqlite3_wal_checkpoint_v2(handle, nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
    sqlite3_busy_timeout(handle, busy_timeout_ms_);
    return outcome == SQLITE_OK;
}

void Connection::keep_log(bool keep) {
    sqlite3_db_config(database_.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, keep ? 1 : 0,
                      nullptr);
}

bool Connection::has_moved() {
    int moved = 0;
    sqlite3_file_control(database_.getHandle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    return moved != 0;
}

namespace {

/// Opens once. Errors: also index_replaced when the log beside it serves another file.
Result<std::unique_ptr<Connection>> open_once(const fs::path& path, Access access) {
    using Opened = Result<std::unique_ptr<Connection>>;
    const auto kind = inspect_file(path);
    if (!kind) return kind.error();
    if (*kind == FileKind::kMissing) {
        return {ErrorCode::kIndexNotFound, path.string() + ": no such index"};
    }
    if (*kind == FileKind::kEmpty) return foreign_index(path, "the file is empty");
    const bool keeps_log = access == Access::kInspect && !log_is_empty(path);
    const bool log_in_use = log_is_in_use(path);
    return guarded(path, [&]() -> Opened {
        auto connection = access == Access::kReadWrite
                              ? std::make_unique<Connection>(path, SQLite::OPEN_READWRITE)
                              : open_reader(path);
        connection->keep_log(keeps_log || log_in_use);  // until it is known whose it is
        const std::int64_t version = connection->integer("PRAGMA user_version");
        if (version > schema_version()) return newer_index(path, version);
        if (version <= 0) return foreign_index(path, "it has no schema");
        // Kept by the file, so that this changes it once only.
        if (access == Access::kReadWrite) {
            connection->database().exec("PRAGMA journal_mode = WAL");
        }
        if (log_in_use && log_serves_another_file(path)) {
            return {ErrorCode::kIndexReplaced,
                    path.string() +
                        ": a running program still uses the log of the file that was "
                        "here before"};
        }
        connection->keep_log(keeps_log);
        if (access == Access::kReadWrite) migrate(*connection);
        if (access != Access::kReadOnly || version == schema_version()) return connection;
        connection.reset();
        auto writer = open_once(path, Access::kReadWrite);
        if (!writer) {
            return {writer.error().code,
                    "index of version " + std::to_string(version) +
                        " has to be migrated first, which failed: " + writer.error().message};
        }
        return open_reader(path);
    });
}

/// Calls `attempt` again while the log is another file's, whose user has to let go of it first.
template <typename Attempt>
std::invoke_result_t<Attempt> once_log_is_free(Attempt&& attempt) {
    const auto deadline = std::chrono::steady_clock::now() + kLogTimeout;
    for (;;) {
        auto outcome = attempt();
        if (outcome || outcome.error().code != ErrorCode::kIndexReplaced ||
            std::chrono::steady_clock::now() > deadline) {
            return outcome;
        }
        std::this_thread::sleep_for(kLogInterval);
    }
}

Result<void> make_once(const fs::path& path, const IndexParameters& parameters) {
    const auto kind = inspect_file(path);
    if (!kind) return kind.error();
    if (*kind == FileKind::kIndex) {
        const auto connection = open_once(path, Access::kReadWrite);
        if (connection) return {};
        if (connection.error().code != ErrorCode::kIndexForeign) return connection.error();
        // Opening undid a creation that was cut short, if that was all there was.
        const auto now = inspect_file(path);
        if (!now || *now != FileKind::kEmpty) return connection.error();
    }
    const fs::path folder = fs::absolute(path).parent_path();
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        return {ErrorCode::kIndexIo,
                path.string() + ": cannot be made, there is no folder " + folder.string()};
    }
    if (log_is_in_use(path)) {
        return {ErrorCode::kIndexReplaced,
                path.string() +
                    ": a running program still uses the log of the file that was here "
                    "before"};
    }
    return guarded(path, [&]() -> Result<void> {
        Connection creator(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        initialize(creator, parameters);
        return {};
    });
}

}  // namespace

Result<std::unique_ptr<Connection>> open_connection(const fs::path& path, Access access) {
    return once_log_is_free([&] { return open_once(path, access); });
}

Result<void> make_index(const fs::path& path, const IndexParameters& parameters) {
    return once_log_is_free([&] { return make_once(path, parameters); });
}

}  // namespace ossuary::index
