#include "index/store_verify_rows.h"

#include <map>

#include "index/content_hash.h"
#include "index/migrations.h"

namespace ossuary::index {

namespace {

/// The SQL of everything in a schema by kind and name; none where SQLite makes it by itself.
std::map<std::string, std::string> read_schema(SQLite::Database& database) {
    std::map<std::string, std::string> schema;
    SQLite::Statement rows(database,
                           "SELECT type || ' ' || name, sql FROM sqlite_schema "
                           "WHERE name NOT LIKE 'sqlite!_%' ESCAPE '!'");
    while (rows.executeStep()) {
        schema.emplace(rows.getColumn(0).getString(), rows.getColumn(1).getString());
    }
    return schema;
}

std::map<std::string, std::string> schema_of_version(int version) {
    SQLite::Database fresh(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    for (const Migration& migration : migrations()) {
        if (migration.version <= version) fresh.exec(std::string(migration.sql));
    }
    return read_schema(fresh);
}

/// What the pieces of an upload are together.
struct Pieces {
    std::int64_t count = 0;
    std::int64_t size = 0;
    std::string bytes;
};

Pieces read_pieces(Store::Impl& impl, UploadId id) {
    Pieces pieces;
    Query rows(
        impl.statement("SELECT piece, bytes FROM upload_pieces WHERE upload = ? ORDER BY piece"));
    rows.bind(id);
    while (rows.step()) {
        ++pieces.count;
        pieces.bytes += rows.blob(1);
    }
    pieces.size = static_cast<std::int64_t>(pieces.bytes.size());
    return pieces;
}

}  // namespace

void verify_schema(Store::Impl& impl, VerifyReport& report) {
    const auto expected = schema_of_version(impl.version);
    const auto found = read_schema(impl.database());
    for (const auto& [name, sql] : expected) {
        const auto there = found.find(name);
        if (there == found.end()) {
            report.findings.push_back({"schema", name + " is missing"});
        } else if (there->second != sql) {
            report.findings.push_back({"schema", name + " is not as version " +
                                                     std::to_string(impl.version) + " has it"});
        }
    }
    for (const auto& entry : found) {
        if (!expected.contains(entry.first)) {
            report.findings.push_back({"schema", entry.first + " does not belong there"});
        }
    }
}

void verify_checksums(Store::Impl& impl, VerifyReport& report) {
    for (const ChecksummedTable& table : checksummed_tables(impl.version)) {
        const std::string name(table.table);
        Query rows(impl.statement("SELECT " + std::string(table.key) + " FROM " + name +
                                  " WHERE checksum IS NOT " + checksum_of(table)));
        while (rows.step()) {
            report.findings.push_back(
                {"table " + name + ", " + std::string(table.key) + " " + rows.text(0),
                 "checksum does not match"});
        }
    }
}

void verify_uploads(Store::Impl& impl, VerifyReport& report) {
    Query rows(impl.statement("SELECT id, state, content_hash, size FROM uploads ORDER BY id"));
    while (rows.step()) {
        ++report.uploads;
        const UploadId id = rows.integer(0);
        const auto find = [&](std::string what) {
            report.findings.push_back({"upload " + std::to_string(id), std::move(what)});
        };
        const Pieces pieces = read_pieces(impl, id);
        if (rows.text(1) == "done" || rows.text(1) == "failed") {
            if (pieces.count != 0) find("it is finished, but its bytes are still there");
        } else if (pieces.size != rows.integer(3)) {
            find(std::to_string(pieces.size) + " bytes, expected " +
                 std::to_string(rows.integer(3)));
        } else if (content_hash(pieces.bytes) != rows.text(2)) {
            find("its bytes are not those of its hash");
        }
    }
}

}  // namespace ossuary::index
