#include "index/store_file.h"

#include <sqlite3.h>

#include <array>

#include "index/migrations.h"
#include "index/store_connection.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

/// Up to a hundred bytes from the start of a file.
using Header = std::string;
constexpr std::size_t kHeaderSize = 100;

std::uint32_t big_endian_32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
        value = value << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return value;
}

/// Those of the file itself, whatever its log says. `immutable` keeps SQLite from looking for locks
/// and logs, which would be the first step to changing what may not be an index.
Result<Header> read_header(const fs::path& path) {
    return guarded(path, [&]() -> Result<Header> {
        const Error unreadable = {ErrorCode::kIndexIo, path.string() + ": cannot be read"};
        SQLite::Database database(file_uri(path, "?immutable=1"),
                                  SQLite::OPEN_READONLY | SQLite::OPEN_URI);
        sqlite3_file* file = nullptr;
        if (sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_FILE_POINTER, &file) !=
                SQLITE_OK ||
            file == nullptr || file->pMethods == nullptr) {
            return unreadable;
        }
        sqlite3_int64 size = 0;
        if (file->pMethods->xFileSize(file, &size) != SQLITE_OK) return unreadable;
        Header header(std::min(kHeaderSize, static_cast<std::size_t>(size)), '\0');
        if (!header.empty() && file->pMethods->xRead(file, header.data(),
                                                     static_cast<int>(header.size()),
                                                     0) != SQLITE_OK) {
            return unreadable;
        }
        return header;
    });
}

}  // namespace

Error foreign_index(const fs::path& path, std::string_view found) {
    return {ErrorCode::kIndexForeign,
            path.string() + ": not an Ossuary index (" + std::string(found) + ")"};
}

Error newer_index(const fs::path& path, std::int64_t version) {
    return {ErrorCode::kIndexNewer,
            path.string() + ": index of version " + std::to_string(version) +
                ", this program knows versions up to " + std::to_string(schema_version()) +
                "; use the program that made it, or a later one"};
}

std::string file_uri(const fs::path& path, std::string_view query) {
    // Percent-encodes what the URI would take for its own.
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

bool log_is_empty(const fs::path& path) {
    std::error_code error;
    const auto size = fs::file_size(path.string() + "-wal", error);
    return error || size == 0;
}

Result<FileKind> inspect_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) return FileKind::kMissing;
    if (error) return {ErrorCode::kIndexIo, path.string() + ": " + error.message()};
    if (status.type() != fs::file_type::regular) return foreign_index(path, "not a regular file");
    const auto header = read_header(path);
    if (!header) return header.error();
    if (header->empty()) return FileKind::kEmpty;
    constexpr std::string_view kMagic("SQLite format 3\0", 16);
    if (header->size() != kHeaderSize || !header->starts_with(kMagic)) {
        return foreign_index(path, "its first bytes are those of another format");
    }
    // SQLite's file format, sec. 1.3: user version at 60, application id at 68.
    if (big_endian_32(*header, 68) != static_cast<std::uint32_t>(kApplicationId)) {
        return foreign_index(path, "an SQLite database of another program");
    }
    const std::uint32_t version = big_endian_32(*header, 60);
    if (version > static_cast<std::uint32_t>(schema_version())) return newer_index(path, version);
    return FileKind::kIndex;
}

}  // namespace ossuary::index
