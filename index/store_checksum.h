#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>
#include <string_view>
#include <vector>

#include "index/migrations.h"

// Private to the store: the checksums of rows that are not blobs.

namespace ossuary::index {

/// A table whose rows carry a checksum of some of their columns.
struct ChecksummedTable {
    std::string_view table;
    std::string_view key;                  ///< column that names a row in findings
    std::string_view columns;              ///< in the order that the checksum takes them
    int since = kFirstVersionWithUploads;  ///< the version of the schema that has it
};

/// Those of a version of the schema; none before 4.
[[nodiscard]] std::vector<ChecksummedTable> checksummed_tables(int version);

/// Gives the connection the SQL function `row_checksum(value, …)`: the XXH3-64 of the values, of
/// each a byte for its type and then its bytes (docs/index-format.md).
void add_checksum_function(SQLite::Database& database);

/// "row_checksum(<columns>)" of a checksummed table.
[[nodiscard]] std::string checksum_of(const ChecksummedTable& table);

/// "UPDATE <table> SET checksum = … WHERE <where>": due after every change of such a row.
[[nodiscard]] std::string seal_rows(std::string_view table, std::string_view where);

/// Seals the rows that have no checksum, as a migration to this version of the schema leaves them.
void seal_unsealed_rows(SQLite::Database& database, int version);

}  // namespace ossuary::index
