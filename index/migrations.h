#pragma once

#include <span>
#include <string_view>

namespace ossuary::index {

/// One step of the schema: migrations/NNNN_name.sql, embedded when the program is built.
struct Migration {
    int version = 0;  ///< the schema's version once this has run
    std::string_view name;
    std::string_view sql;
};

/// All migrations, version 1 first and without gaps.
[[nodiscard]] std::span<const Migration> migrations();

/// The version of the schema that this program reads and writes.
[[nodiscard]] inline int schema_version() { return static_cast<int>(migrations().size()); }

/// What came with which version.
inline constexpr int kFirstVersionWithCollection = 2;  ///< statistics, evaluations
inline constexpr int kFirstVersionWithSegments = 3;
inline constexpr int kFirstVersionWithUploads = 4;  ///< and with checksums of rows
inline constexpr int kFirstVersionWithOrientations = 5;
inline constexpr int kFirstVersionWithFrames = 6;    ///< what files say of units and axes
inline constexpr int kFirstVersionWithScan = 7;      ///< blocks of what searches look at
inline constexpr int kFirstVersionWithFeatures = 8;  ///< of surfaces, for parts

}  // namespace ossuary::index
