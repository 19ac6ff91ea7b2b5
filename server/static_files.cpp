#include "server/static_files.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "engine/core/whole_file.h"
#include "server/etag.h"

namespace ossuary::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 64 << 20;

struct EndingType {
    std::string_view ending;
    std::string_view type;
};
constexpr std::array kTypes = {
    EndingType{".html", "text/html; charset=utf-8"},
    EndingType{".js", "text/javascript; charset=utf-8"},
    EndingType{".css", "text/css; charset=utf-8"},
    EndingType{".json", "application/json"},
    EndingType{".webmanifest", "application/manifest+json"},
    EndingType{".map", "application/json"},
    EndingType{".svg", "image/svg+xml"},
    EndingType{".png", "image/png"},
    EndingType{".jpg", "image/jpeg"},
    EndingType{".webp", "image/webp"},
    EndingType{".ico", "image/vnd.microsoft.icon"},
    EndingType{".woff2", "font/woff2"},
    EndingType{".wasm", "application/wasm"},
    EndingType{".txt", "text/plain; charset=utf-8"},
};

}  // namespace

std::string_view content_type_of(std::string_view name) {
    for (const EndingType& each : kTypes) {
        if (name.size() > each.ending.size() && name.ends_with(each.ending)) return each.type;
    }
    return {};
}

bool is_hashed_name(std::string_view name) {
    constexpr std::size_t kHash = 8;
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos || dot < kHash + 2) return false;
    const std::string_view hash = name.substr(dot - kHash, kHash);
    const bool word = std::all_of(hash.begin(), hash.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '_' || c == '-';
    });
    const bool odd = std::any_of(hash.begin(), hash.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
    });
    return word && odd && name[dot - kHash - 1] == '-';
}

Result<StaticFiles> StaticFiles::load(const fs::path& folder) {
    StaticFiles files;
    std::error_code fault;
    if (!fs::is_regular_file(folder / "index.html", fault)) {
        return {ErrorCode::kFileNotFound, folder.string() + ": there is no index.html"};
    }
    std::size_t bytes = 0;
    auto entry = fs::recursive_directory_iterator(folder, fault);
    for (; !fault && entry != fs::recursive_directory_iterator(); entry.increment(fault)) {
        const fs::path& path = entry->path();
        const std::string name = path.filename().string();
        const std::string_view type = content_type_of(name);
        std::error_code ignored;
        if (entry->is_symlink(ignored) || !entry->is_regular_file(ignored) || type.empty())
            continue;
        const auto file = read_whole_file(path, kMaxBytes);
        if (!file) return file.error();
        std::string content(file->view());
        bytes += content.size();
        if (bytes > kMaxBytes) {
            return {ErrorCode::kFileTooLarge, folder.string() + ": more than 64 MB of files"};
        }
        std::string etag = etag_of(content);
        files.files_["/" + path.lexically_relative(folder).generic_string()] = {
            std::string(type), std::move(content), std::move(etag), is_hashed_name(name)};
    }
    if (fault) return {ErrorCode::kFileUnreadable, folder.string() + ": " + fault.message()};
    return files;
}

std::optional<Response> StaticFiles::find(const RequestHead& head) const {
    const auto found = files_.find(head.path == "/" ? "/index.html" : std::string_view(head.path));
    if (found == files_.end()) return std::nullopt;
    const File& file = found->second;
    Response response;
    if (is_current(head, file.etag)) {
        // A 304's headers replace those of the browser's copy: they must be the page's.
        response.status = 304;
        response.content_type = file.content_type;
    } else {
        response = answer(file.content_type, file.content);
    }
    response.set_header("ETag", file.etag);
    response.set_header("Cache-Control",
                        file.immutable ? "public, max-age=31536000, immutable" : "no-cache");
    return response;
}

}  // namespace ossuary::server
