#include <sys/stat.h>

#include <algorithm>
#include <set>
#include <utility>

#include "engine/mesh/read_mesh.h"
#include "index/model_files.h"
#include "index/model_place.h"

namespace ossuary::index {

namespace fs = std::filesystem;

namespace {

/// What a file or folder is whatever its path: its device and its number there.
using FileIdentity = std::pair<dev_t, ino_t>;

/// None when it cannot be told.
std::optional<FileIdentity> identity(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return FileIdentity{status.st_dev, status.st_ino};
}

bool by_bytes(const fs::path& a, const fs::path& b) { return a.native() < b.native(); }

/// Something to be looked at: where it is, and its path below the root that it was found under.
struct Place {
    fs::path path;
    std::string below;
};

class Walk {
public:
    Walk(const WalkOptions& options, std::stop_token stop)
        : options_(options), stop_(std::move(stop)) {}

    void add_root(const fs::path& root);
    /// Once all roots are in: what links lead to.
    void follow_links();
    FoundFiles take();
    [[nodiscard]] bool stopped() const { return stop_.stop_requested(); }

private:
    void walk(const Place& top, bool through_link);
    void look_at(const fs::directory_entry& entry, std::string below, std::vector<Place>& folders);
    void take_file(const Place& file, bool is_link);
    void follow_folder_links();
    void follow_file_links();
    void close_the_way_back(const fs::path& folder);
    [[nodiscard]] bool excluded(std::string_view below, bool is_folder) const {
        return std::any_of(options_.exclude.begin(), options_.exclude.end(),
                           [&](const Glob& glob) { return glob.matches(below, is_folder); });
    }

    const WalkOptions& options_;
    std::stop_token stop_;
    FoundFiles found_;
    std::vector<fs::path> roots_;
    std::vector<Place> folder_links_;
    std::vector<fs::path> file_links_;
    std::set<FileIdentity> walked_;
    std::set<FileIdentity> above_;  ///< folders that lie above one that was walked
};

void Walk::add_root(const fs::path& root) {
    std::error_code error;
    const fs::file_status status = fs::status(root, error);
    if (status.type() == fs::file_type::not_found) {
        // A model in an archive that is there.
        const bool is_there = fs::is_regular_file(place_of(root).file, error);
        (is_there ? found_.files : found_.missing).push_back(root);
    } else if (!fs::status_known(status)) {
        found_.unreadable.push_back(
            {root, {ErrorCode::kFileUnreadable, root.string() + ": " + error.message()}});
    } else if (!fs::is_directory(status)) {
        if (excluded(root.filename().native(), false)) {
            ++found_.passed_over.excluded;
        } else if (fs::canonical(root, error) != root) {
            file_links_.push_back(root);
        } else {
            found_.files.push_back(root);
        }
    } else if (const auto self = identity(root); !self || !walked_.contains(*self)) {
        roots_.push_back(root);
        walk({root, ""}, false);
    } else if (!is_under(root, roots_)) {
        found_.seen_before.push_back(root);
    }
}

/// A link to a folder above would lead to everything again, and to much else.
void Walk::close_the_way_back(const fs::path& folder) {
    std::error_code error;
    fs::path above = fs::canonical(folder, error);
    while (!error && above.has_relative_path()) {
        above = above.parent_path();
        if (const auto self = identity(above)) above_.insert(*self);
    }
}

void Walk::walk(const Place& top, bool through_link) {
    close_the_way_back(top.path);
    std::vector<Place> folders = {top};
    while (!folders.empty() && !stopped()) {
        const Place folder = std::move(folders.back());
        folders.pop_back();
        if (const auto self = identity(folder.path)) {
            // Only what links lead to can have been walked: a tree does not meet itself.
            if (!walked_.insert(*self).second && through_link) continue;
        }
        std::error_code error;
        fs::directory_iterator entry(folder.path, error);
        for (const fs::directory_iterator end; !error && entry != end && !stopped();
             entry.increment(error)) {
            const std::string name = entry->path().filename().native();
            look_at(*entry, folder.below.empty() ? name : folder.below + "/" + name, folders);
        }
        if (error) {
            found_.unreadable.push_back(
                {folder.path,
                 {ErrorCode::kFileUnreadable, folder.path.string() + ": " + error.message()}});
        }
    }
}

void Walk::look_at(const fs::directory_entry& entry, std::string below,
                   std::vector<Place>& folders) {
    const fs::path& path = entry.path();
    if (is_hidden_name(path.filename().native())) {
        ++found_.passed_over.hidden;
        return;
    }
    // What is no link is known without asking the file system again.
    std::error_code error;
    const bool is_link = entry.is_symlink(error);
    const bool is_folder = entry.is_directory(error);
    const bool leads_nowhere = is_link && !fs::exists(entry.status(error));
    if (excluded(below, is_folder)) {
        ++found_.passed_over.excluded;
    } else if (is_folder) {
        (is_link ? folder_links_ : folders).push_back({path, std::move(below)});
    } else if (leads_nowhere) {
        found_.broken_links.push_back(path);
    } else if (!mesh::is_model_file(path)) {
        ++found_.passed_over.other_files;
    } else if (!entry.is_regular_file(error)) {
        ++found_.passed_over.special;
    } else if (is_link) {
        file_links_.push_back(path);
    } else {
        found_.files.push_back(path);
    }
}

void Walk::follow_links() {
    // What one leads to may hold more: in rounds, each in the order of paths.
    while (!folder_links_.empty() && !stopped()) follow_folder_links();
    if (!file_links_.empty() && !stopped()) follow_file_links();
}

void Walk::follow_folder_links() {
    std::vector<Place> links = std::exchange(folder_links_, {});
    std::sort(links.begin(), links.end(),
              [](const Place& a, const Place& b) { return by_bytes(a.path, b.path); });
    for (const Place& link : links) {
        const auto target = identity(link.path);
        if (!target || walked_.contains(*target) || above_.contains(*target)) {
            found_.seen_before.push_back(link.path);
        } else {
            walk(link, true);
        }
    }
}

void Walk::follow_file_links() {
    std::set<FileIdentity> taken;
    for (const fs::path& file : found_.files) {
        if (const auto self = identity(file)) taken.insert(*self);
    }
    std::sort(file_links_.begin(), file_links_.end(), by_bytes);
    for (const fs::path& link : file_links_) {
        const auto target = identity(link);
        if (target && !taken.insert(*target).second) {
            found_.seen_before.push_back(link);
        } else {
            found_.files.push_back(link);
        }
    }
}

FoundFiles Walk::take() {
    for (auto* paths : {&found_.files, &found_.seen_before, &found_.broken_links}) {
        std::sort(paths->begin(), paths->end(), by_bytes);
        paths->erase(std::unique(paths->begin(), paths->end(),
                                 [](const fs::path& a, const fs::path& b) {
                                     return a.native() == b.native();
                                 }),
                     paths->end());
    }
    std::sort(found_.unreadable.begin(), found_.unreadable.end(),
              [](const auto& a, const auto& b) { return by_bytes(a.path, b.path); });
    found_.passed_over.seen_before = found_.seen_before.size();
    found_.passed_over.broken_links = found_.broken_links.size();
    return std::move(found_);
}

/// Roots that are no links first, so that files are known by their own paths; each once.
std::vector<fs::path> ordered_roots(const std::vector<fs::path>& paths) {
    std::vector<std::pair<bool, fs::path>> roots;
    for (const fs::path& named : paths) {
        const fs::path path = index_path(named);
        std::error_code error;
        const bool is_link = fs::canonical(path, error) != path;
        roots.emplace_back(is_link, path);
    }
    std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? b.first : by_bytes(a.second, b.second);
    });
    std::vector<fs::path> ordered;
    for (auto& [is_link, path] : roots) {
        if (ordered.empty() || ordered.back().native() != path.native()) {
            ordered.push_back(std::move(path));
        }
    }
    return ordered;
}

}  // namespace

Result<FoundFiles> find_model_files(const std::vector<fs::path>& paths, const WalkOptions& options,
                                    std::stop_token stop) {
    Walk walk(options, std::move(stop));
    const std::vector<fs::path> roots = ordered_roots(paths);
    for (const fs::path& root : roots) walk.add_root(root);
    walk.follow_links();
    if (walk.stopped()) return {ErrorCode::kCancelled, "looking for models was stopped"};
    FoundFiles found = walk.take();
    return found;
}

}  // namespace ossuary::index
