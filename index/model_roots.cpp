#include "index/model_roots.h"

#include <algorithm>
#include <map>

namespace ossuary::index {

namespace {

/// With its slash. What follows a `#` lies within a file and may have slashes of its own.
std::string_view folder_of(std::string_view path) {
    const std::size_t inside = std::min(path.find('#'), path.size());
    return path.substr(0, path.rfind('/', inside) + 1);
}

std::string_view common_folder(std::string_view a, std::string_view b) {
    const auto [end, ignored] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return folder_of(a.substr(0, static_cast<std::size_t>(end - a.begin())));
}

/// `/home` of `/home/eva/models/`.
std::string_view top_of(std::string_view folder) {
    return folder.substr(0, folder.find('/', std::min<std::size_t>(1, folder.size())));
}

}  // namespace

ModelRoots::ModelRoots(std::span<const std::string> paths) {
    std::map<std::string_view, std::string_view> by_top;
    for (const std::string& path : paths) {
        if (path.empty()) continue;
        const std::string_view folder = folder_of(path);
        const auto [root, first] = by_top.try_emplace(top_of(folder), folder);
        if (!first) root->second = common_folder(root->second, folder);
    }
    for (const auto& [top, root] : by_top) roots_.emplace_back(root);
    // Models in the machine's own root make it one of them, which all other roots lie below.
    std::stable_sort(roots_.begin(), roots_.end(), [](const std::string& a, const std::string& b) {
        return a.size() > b.size();
    });
}

std::string ModelRoots::relative(std::string_view path) const {
    for (const std::string& root : roots_) {
        if (root.empty() || !path.starts_with(root)) continue;
        const std::size_t name = root.rfind('/', root.size() - 2);
        const bool alone = roots_.size() == 1 || name == std::string::npos;
        return std::string(path.substr(alone ? root.size() : name + 1));
    }
    return std::string(path.substr(folder_of(path).size()));
}

}  // namespace ossuary::index
