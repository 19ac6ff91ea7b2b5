#include "index/store_checksum.h"

#include <sqlite3.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <iterator>
#include <new>

#include "index/bytes.h"

namespace ossuary::index {

namespace {

void put_value(ByteWriter& writer, sqlite3_value* value) {
    const int type = sqlite3_value_type(value);
    switch (type) {
        case SQLITE_INTEGER:
            writer.put('i');
            writer.put(static_cast<std::int64_t>(sqlite3_value_int64(value)));
            return;
        case SQLITE_FLOAT:
            writer.put('r');
            writer.put(sqlite3_value_double(value));
            return;
        case SQLITE_NULL:
            writer.put('n');
            return;
        default:
            break;
    }
    writer.put(type == SQLITE_TEXT ? 't' : 'b');
    // Of a text the bytes as they are stored, which need not be UTF-8.
    const auto* bytes = static_cast<const char*>(sqlite3_value_blob(value));
    const auto size = static_cast<std::size_t>(sqlite3_value_bytes(value));
    writer.put_text(bytes == nullptr ? std::string_view() : std::string_view(bytes, size));
}

extern "C" void row_checksum(sqlite3_context* context, int count, sqlite3_value** values) {
    try {
        ByteWriter writer;
        for (int i = 0; i < count; ++i) put_value(writer, values[i]);
        const std::uint64_t sum = XXH3_64bits(writer.bytes().data(), writer.bytes().size());
        sqlite3_result_int64(context, std::bit_cast<std::int64_t>(sum));
    } catch (const std::bad_alloc&) {
        sqlite3_result_error_nomem(context);
    }
}

constexpr std::array kTables = {
    ChecksummedTable{"parameters", "name", "name, value"},
    ChecksummedTable{"state", "id", "id, revision"},
    ChecksummedTable{"models", "id",
                     "id, path, name, class, content_hash, vertices, faces, nodes, branches, "
                     "min_x, min_y, min_z, max_x, max_y, max_z, surface_area, warnings, "
                     "indexed_at, revision"},
    ChecksummedTable{"failures", "path", "path, content_hash, code, message, failed_at"},
    ChecksummedTable{"statistics", "id", "id, revision"},
    ChecksummedTable{"evaluations", "ranker",
                     "revision, ranker, rerank, pose, collection_hash, computed_at"},
    ChecksummedTable{"uploads", "id",
                     "id, name, class, content_hash, size, state, claimant, attempts, model, code, "
                     "message, accepted_at, finished_at"},
    ChecksummedTable{"file_frames", "model", "model, metres_per_unit, up", kFirstVersionWithFrames},
};

}  // namespace

std::vector<ChecksummedTable> checksummed_tables(int version) {
    std::vector<ChecksummedTable> tables;
    std::copy_if(kTables.begin(), kTables.end(), std::back_inserter(tables),
                 [&](const ChecksummedTable& table) { return table.since <= version; });
    return tables;
}

void add_checksum_function(SQLite::Database& database) {
    constexpr int kAnyCount = -1;
    database.createFunction("row_checksum", kAnyCount, true, nullptr, row_checksum);
}

std::string checksum_of(const ChecksummedTable& table) {
    return "row_checksum(" + std::string(table.columns) + ")";
}

std::string seal_rows(std::string_view table, std::string_view where) {
    const auto found =
        std::find_if(kTables.begin(), kTables.end(),
                     [&](const ChecksummedTable& each) { return each.table == table; });
    assert(found != kTables.end());
    return "UPDATE " + std::string(table) + " SET checksum = " + checksum_of(*found) + " WHERE " +
           std::string(where);
}

void seal_unsealed_rows(SQLite::Database& database, int version) {
    for (const ChecksummedTable& table : checksummed_tables(version)) {
        database.exec(seal_rows(table.table, "checksum IS NULL"));
    }
}

}  // namespace ossuary::index
