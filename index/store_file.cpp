#include "index/store_file.h"

#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

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
        if (!header.empty() &&
            file->pMethods->xRead(file, header.data(), static_cast<int>(header.size()), 0) !=
                SQLITE_OK) {
            return unreadable;
        }
        return header;
    });
}

/// Where SQLite keeps the log of an index that is opened through a link.
fs::path real_path(const fs::path& path) {
    std::error_code error;
    fs::path real = fs::canonical(path, error);
    return error ? path : real;
}

/// Bytes of a file that a process has locked.
struct HeldLock {
    std::int64_t process = 0;
    FileId file;
    std::uint64_t first = 0, last = 0;
};

/// A line of /proc/locks, e.g. "1: POSIX  ADVISORY  READ 1234 fe:00:5678 128 128".
std::optional<HeldLock> parse_lock(const std::string& line) {
    std::istringstream words(line);
    std::string number, kind, strictness, mode, place, last;
    HeldLock lock;
    if (!(words >> number >> kind >> strictness >> mode >> lock.process >> place >> lock.first >>
          last) ||
        kind != "POSIX") {
        return {};
    }
    unsigned major = 0, minor = 0;
    unsigned long long inode = 0;
    if (std::sscanf(place.c_str(), "%x:%x:%llu", &major, &minor, &inode) != 3) return {};
    lock.file = {makedev(major, minor), inode};
    lock.last = last == "EOF" ? ~std::uint64_t{0} : std::strtoull(last.c_str(), nullptr, 10);
    return lock;
}

/// The processes that use `log` (a -shm file), and those of them that have `index` open.
struct LogUsers {
    std::set<std::int64_t> of_log, of_index;
};

LogUsers log_users(const FileId& log, const FileId& index) {
    // SQLite 3: every connection to an index in WAL mode has a shared lock on the "dead man's
    // switch" of its -shm, and one on the file itself from before until after that.
    constexpr std::uint64_t kSwitch = 128;
    constexpr std::uint64_t kSharedFirst = 0x40000002;
    constexpr std::uint64_t kSharedLast = kSharedFirst + 509;
    LogUsers users;
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {
        const auto lock = parse_lock(line);
        if (!lock) continue;
        const auto covers = [&](std::uint64_t first, std::uint64_t last) {
            return lock->first <= last && lock->last >= first;
        };
        if (lock->file == log && covers(kSwitch, kSwitch)) users.of_log.insert(lock->process);
        if (lock->file == index && covers(kSharedFirst, kSharedLast)) {
            users.of_index.insert(lock->process);
        }
    }
    return users;
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
    const auto size = fs::file_size(real_path(path).string() + "-wal", error);
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

Result<std::optional<FileId>> file_at(const fs::path& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) {
        return std::optional(FileId{status.st_dev, status.st_ino});
    }
    if (errno == ENOENT || errno == ENOTDIR) return std::optional<FileId>();
    return {ErrorCode::kIndexIo, path.string() + ": " + std::strerror(errno)};
}

bool log_serves_another_file(const fs::path& path) {
    const fs::path real = real_path(path);
    // Locks are listed one after the other while processes come and go: what is seen twice is so.
    for (int look = 0; look < 2; ++look) {
        if (look > 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const auto index = file_at(real);
        const auto log = file_at(real.string() + "-shm");
        if (!index || !*index || !log || !*log) return false;
        const LogUsers users = log_users(**log, **index);
        const std::int64_t self = getpid();
        // Some file systems list other numbers than they tell.
        if (!users.of_log.contains(self) || !users.of_index.contains(self)) return false;
        const bool all_use_the_index = std::includes(users.of_index.begin(), users.of_index.end(),
                                                     users.of_log.begin(), users.of_log.end());
        if (all_use_the_index) return false;
    }
    return true;
}

bool log_is_in_use(const fs::path& path) {
    const auto log = file_at(real_path(path).string() + "-shm");
    return log && *log && !log_users(**log, {}).of_log.empty();
}

}  // namespace ossuary::index
