#include "index/model_files.h"

#include <algorithm>
#include <fstream>
#include <set>

#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

namespace fs = std::filesystem;

namespace {

/// Adds the model files below a folder; what cannot be read is passed over.
void walk(const fs::path& folder, std::vector<fs::path>& files) {
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           error);
    const fs::recursive_directory_iterator end;
    while (!error && entry != end) {
        std::error_code unreadable;
        if (entry->is_regular_file(unreadable) && mesh::is_model_file(entry->path())) {
            files.push_back(entry->path());
        }
        entry.increment(error);
    }
}

}  // namespace

fs::path index_path(const fs::path& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    fs::path normal = (error ? path : absolute).lexically_normal();
    // "folder/" and "folder" are the same.
    if (!normal.has_filename() && normal.has_parent_path() && normal != normal.root_path()) {
        normal = normal.parent_path();
    }
    return normal;
}

Result<std::vector<fs::path>> find_model_files(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& named : paths) {
        const fs::path path = index_path(named);
        std::error_code error;
        const fs::file_status status = fs::status(path, error);
        if (!fs::exists(status)) {
            return {ErrorCode::kFileNotFound, named.string() + ": no such file or folder"};
        }
        if (fs::is_directory(status)) {
            walk(path, files);
        } else {
            files.push_back(path);
        }
    }
    const auto bytes = [](const fs::path& path) -> const std::string& { return path.native(); };
    std::sort(files.begin(), files.end(),
              [&](const fs::path& a, const fs::path& b) { return bytes(a) < bytes(b); });
    files.erase(
        std::unique(files.begin(), files.end(),
                    [&](const fs::path& a, const fs::path& b) { return bytes(a) == bytes(b); }),
        files.end());
    return files;
}

bool is_under(const fs::path& path, const std::vector<fs::path>& roots) {
    return std::any_of(roots.begin(), roots.end(), [&](const fs::path& root) {
        const auto [root_at, path_at] =
            std::mismatch(root.begin(), root.end(), path.begin(), path.end());
        return root_at == root.end();
    });
}

Result<std::string> read_bytes(const fs::path& path, std::uint64_t max_bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) return {ErrorCode::kFileNotFound, path.string() + ": no such file"};
    if (!fs::is_regular_file(status)) {
        return {ErrorCode::kFileUnreadable, path.string() + ": not a regular file"};
    }
    const std::uint64_t size = fs::file_size(path, error);
    if (error) return {ErrorCode::kFileUnreadable, path.string() + ": " + error.message()};
    if (size > max_bytes) {
        return {ErrorCode::kFileTooLarge, path.string() + ": " + std::to_string(size) +
                                              " bytes, at most " + std::to_string(max_bytes) +
                                              " are read"};
    }
    std::ifstream file(path, std::ios::binary);
    std::string bytes(size, '\0');
    if (!file || !file.read(bytes.data(), static_cast<std::streamsize>(size))) {
        return {ErrorCode::kFileUnreadable, path.string() + ": cannot be read"};
    }
    return bytes;
}

std::map<std::string, std::string> classes_by_file_name(
    const ranking::Classification& classification, const std::vector<fs::path>& files) {
    std::set<std::string> present;
    for (const fs::path& file : files) present.insert(file.filename().string());
    std::map<std::string, std::string> classes;
    for (const ranking::ClassifiedModel& model : ranking::models_in_order(classification)) {
        for (const std::string& name : ranking::candidate_file_names(model.id)) {
            if (!present.contains(name)) continue;
            classes.emplace(name, model.class_name);
            break;
        }
    }
    return classes;
}

}  // namespace ossuary::index
