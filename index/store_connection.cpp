#include "index/store_connection.h"

#include <sqlite3.h>

#include <array>

#include "index/migrations.h"
#include "index/store_file.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

constexpr int kBusyTimeoutMs = 10'000;

/// A reader's connection. On a medium where SQLite cannot keep its -shm file an index is still
/// readable if its log is empty, because then nobody can be writing it.
std::unique_ptr<Connection> open_reader(const fs::path& path) {
    try {
        auto connection = std::make_unique<Connection>(path, SQLite::OPEN_READONLY);
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

Result<std::unique_ptr<Connection>> open_connection(const fs::path& path, Access access) {
    using Opened = Result<std::unique_ptr<Connection>>;
    const auto kind = inspect_file(path);
    if (!kind) return kind.error();
    if (*kind == FileKind::kMissing) {
        return {ErrorCode::kIndexNotFound, path.string() + ": no such index"};
    }
    if (*kind == FileKind::kEmpty) return foreign_index(path, "the file is empty");
    return guarded(path, [&]() -> Opened {
        auto connection = access == Access::kReadOnly
                              ? open_reader(path)
                              : std::make_unique<Connection>(path, SQLite::OPEN_READWRITE);
        const std::int64_t version = connection->integer("PRAGMA user_version");
        if (version > schema_version()) return newer_index(path, version);
        if (version <= 0) return foreign_index(path, "it has no schema");
        if (access == Access::kReadWrite) {
            migrate(*connection);
            // Kept by the file, so that this changes it once only.
            connection->database().exec("PRAGMA journal_mode = WAL");
            return connection;
        }
        if (version == schema_version()) return connection;
        connection.reset();
        auto writer = open_connection(path, Access::kReadWrite);
        if (!writer) {
            return {writer.error().code,
                    "index of version " + std::to_string(version) +
                        " has to be migrated first, which failed: " + writer.error().message};
        }
        return open_reader(path);
    });
}

Result<std::unique_ptr<Connection>> create_connection(const fs::path& path,
                                                      const IndexParameters& parameters) {
    return guarded(path, [&]() -> Result<std::unique_ptr<Connection>> {
        Connection creator(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        initialize(creator, parameters);
        return open_connection(path, Access::kReadWrite);
    });
}

}  // namespace ossuary::index
