#include "index/model_files.h"

#include <algorithm>
#include <set>

#include "index/model_place.h"

namespace ossuary::index {

namespace fs = std::filesystem;

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

bool is_under(const fs::path& path, const std::vector<fs::path>& roots) {
    return std::any_of(roots.begin(), roots.end(), [&](const fs::path& root) {
        const auto [root_at, path_at] =
            std::mismatch(root.begin(), root.end(), path.begin(), path.end());
        return root_at == root.end();
    });
}

bool is_hidden_name(std::string_view name) {
    constexpr std::string_view kNames[] = {"@eadir",       "#recycle",
                                           "$recycle.bin", "system volume information",
                                           "__macosx",     "lost+found"};
    if (name.starts_with('.')) return true;
    std::string lower(name);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return std::find(std::begin(kNames), std::end(kNames), lower) != std::end(kNames);
}

namespace {

bool is_excluded(std::string_view below, bool is_folder, const WalkOptions& options) {
    return std::any_of(options.exclude.begin(), options.exclude.end(),
                       [&](const Glob& glob) { return glob.matches(below, is_folder); });
}

/// As is_passed_over, for one root that `path` lies under.
bool root_passes_over(const fs::path& path, const fs::path& root, const WalkOptions& options) {
    const fs::path relative = path.lexically_relative(root);
    // A file that is named itself.
    if (relative == ".") return is_excluded(path.filename().native(), false, options);
    fs::path below;
    for (auto part = relative.begin(); part != relative.end(); ++part) {
        below /= *part;
        const bool is_folder = std::next(part) != relative.end();
        if (is_hidden_name(part->native()) || is_excluded(below.native(), is_folder, options)) {
            return true;
        }
    }
    return false;
}

}  // namespace

bool is_passed_over(const fs::path& path, const std::vector<fs::path>& roots,
                    const WalkOptions& options) {
    bool under_one = false;
    for (const fs::path& root : roots) {
        if (!is_under(path, {root})) continue;
        if (!root_passes_over(path, root, options)) return false;
        under_one = true;
    }
    return under_one;
}

std::map<std::string, std::string> classes_by_file_name(
    const ranking::Classification& classification, const std::vector<fs::path>& files) {
    std::set<std::string> present;
    for (const fs::path& file : files) present.insert(place_of(file).file_name().string());
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
