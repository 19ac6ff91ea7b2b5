#include "engine/core/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace ossuary {
namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, Close>;

Error failure(ErrorCode code, const std::filesystem::path& path, int reason) {
    return {code,
            path.string() + ": " + std::error_code(reason, std::generic_category()).message()};
}

}  // namespace

Result<WholeFile> read_whole_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
    namespace fs = std::filesystem;
    const std::string name = path.string();
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) {
        return {ErrorCode::kFileNotFound, name + ": no such file"};
    }
    if (!fs::is_regular_file(status)) {
        return {ErrorCode::kFileUnreadable,
                name + ": " + (error ? error.message() : "not a regular file")};
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) return {ErrorCode::kFileUnreadable, name + ": " + error.message()};
    if (size > max_bytes) {
        return {ErrorCode::kFileTooLarge, name + ": expected at most " + std::to_string(max_bytes) +
                                              " bytes, found " + std::to_string(size)};
    }
    const OpenFile file(std::fopen(path.c_str(), "rb"));
    if (!file) return failure(ErrorCode::kFileUnreadable, path, errno);
    WholeFile contents(size);
    errno = 0;
    contents.shorten(std::fread(contents.data(), 1, size, file.get()));
    if (std::ferror(file.get()) != 0) return failure(ErrorCode::kFileUnreadable, path, errno);
    return contents;
}

Result<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
    OpenFile file(std::fopen(path.c_str(), "wb"));
    if (!file) return failure(ErrorCode::kFileUnwritable, path, errno);
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    const int reason = errno;
    // What the system kept back is reported when the file is closed.
    const bool closed = std::fclose(file.release()) == 0;
    if (!written) return failure(ErrorCode::kFileUnwritable, path, reason);
    if (!closed) return failure(ErrorCode::kFileUnwritable, path, errno);
    return {};
}

}  // namespace ossuary
