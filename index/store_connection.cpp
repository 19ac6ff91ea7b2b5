#include "index/store_connection.h"

#include <sqlite3.h>

#include <array>
#include <fstream>

#include "index/migrations.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

constexpr int kBusyTimeoutMs = 10'000;

std::uint32_t big_endian_32(const char* bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

Error foreign(const fs::path& path, std::string_view found) {
    return {ErrorCode::kIndexForeign,
            path.string() + ": not an Ossuary index (" + std::string(found) + ")"};
}

Error newer(const fs::path& path, std::int64_t version) {
    return {ErrorCode::kIndexNewer,
            path.string() + ": index of version " + std::to_string(version) +
                ", this program knows versions up to " + std::to_string(schema_version()) +
                "; use the program that made it, or a later one"};
}

/// Percent-encodes what an SQLite file: URI would take for its own.
std::string file_uri(const fs::path& path, std::string_view query) {
    std::string uri = "file:";
    for (const char c : fs::absolute(path).string()) {
        if (c == '%' || c == '?' || c == '#') {
            constexpr std::string_view kDigits = "0123456789ABCDEF";
            uri += '%';
            uri += kDigits[static_cast<unsigned char>(c) >> 4];
            uri += kDigits[static_cast<unsigned char>(c) & 15U];
        } else {
            uri += c;
        }
    }
    return uri + std::string(query);
}

/// True when nothing waits in the write-ahead log, so that the file alone is the index.
bool log_is_empty(const fs::path& path) {
    std::error_code error;
    const auto size = fs::file_size(path.string() + "-wal", error);
    return error || size == 0;
}

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

Result<FileKind> inspect_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) return FileKind::kMissing;
    if (error) return {ErrorCode::kIndexIo, path.string() + ": " + error.message()};
    if (status.type() != fs::file_type::regular) return foreign(path, "not a regular file");
    std::ifstream file(path, std::ios::binary);
    if (!file) return {ErrorCode::kIndexIo, path.string() + ": cannot be opened for reading"};
    std::array<char, 100> header{};
    file.read(header.data(), header.size());
    if (file.bad()) return {ErrorCode::kIndexIo, path.string() + ": cannot be read"};
    if (file.gcount() == 0) return FileKind::kEmpty;
    constexpr std::string_view kMagic("SQLite format 3\0", 16);
    if (file.gcount() != static_cast<std::streamsize>(header.size()) ||
        std::string_view(header.data(), kMagic.size()) != kMagic) {
        return foreign(path, "its first bytes are those of another format");
    }
    // SQLite's file format, sec. 1.3: user version at 60, application id at 68.
    if (big_endian_32(&header[68]) != static_cast<std::uint32_t>(kApplicationId)) {
        return foreign(path, "an SQLite database of another program");
    }
    const std::uint32_t version = big_endian_32(&header[60]);
    if (version > static_cast<std::uint32_t>(schema_version())) return newer(path, version);
    return FileKind::kIndex;
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
    if (*kind == FileKind::kEmpty) return foreign(path, "the file is empty");
    return guarded(path, [&]() -> Opened {
        auto connection = access == Access::kReadOnly
                              ? open_reader(path)
                              : std::make_unique<Connection>(path, SQLite::OPEN_READWRITE);
        const std::int64_t version = connection->integer("PRAGMA user_version");
        if (version > schema_version()) return newer(path, version);
        if (version <= 0) return foreign(path, "it has no schema");
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
