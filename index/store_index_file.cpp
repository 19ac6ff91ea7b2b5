#include "index/store_index_file.h"

#include <algorithm>
#include <map>

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

/// How long a log is waited for that other programs are reading.
constexpr int kFoldTimeoutMs = 1000;

bool names(const fs::path& path, const FileId& file) {
    const auto found = file_at(path);
    // What cannot be told is no reason to let go of a file that works.
    return !found || *found == file;
}

}  // namespace

std::shared_ptr<IndexFile> IndexFile::at(const fs::path& path) {
    // The one thing that a process has only one of: its descriptors and their locks.
    static Mutex mutex;
    static std::map<fs::path, std::weak_ptr<IndexFile>> files OSSUARY_GUARDED_BY(mutex);
    const Lock lock(mutex);
    std::erase_if(files, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<IndexFile>& known = files[fs::absolute(path).lexically_normal()];
    auto file = known.lock();
    if (!file) {
        file = std::make_shared<IndexFile>(path);
        known = file;
    }
    return file;
}

bool IndexFile::stands() const { return !file_ || names(path_, *file_); }

void IndexFile::let_go_of_replaced() {
    if (stands()) return;
    // What waits in the log belongs to the file that was here. Left beside the new one it would be
    // read into that, so it goes home now, also when that file is about to vanish.
    for (auto* holder : holders_) {
        if ((*holder)->fold_log(kFoldTimeoutMs)) break;
    }
    for (auto* holder : holders_) holder->reset();
    holders_.clear();
    file_.reset();
    ++replacements_;
}

Result<void> IndexFile::open(std::unique_ptr<Connection>& holder, Access access) {
    let_go_of_replaced();
    for (int attempt = 0; attempt < 10; ++attempt) {
        auto connection = open_connection(path_, access);
        if (!connection) return connection.error();
        const auto found = file_at(path_);
        if (!found) return found.error();
        // It may have been replaced in this very moment.
        if (!*found || (*connection)->has_moved()) continue;
        if (file_ && *file_ != **found) {
            (*connection)->keep_log(true);  // it is the earlier file's
            connection->reset();
            let_go_of_replaced();
            continue;
        }
        file_ = **found;
        holder = *std::move(connection);
        holders_.push_back(&holder);
        return {};
    }
    return {ErrorCode::kIndexReplaced,
            path_.string() + ": is replaced faster than it can be opened"};
}

void IndexFile::close(std::unique_ptr<Connection>& holder) {
    std::erase(holders_, &holder);
    holder.reset();
    if (holders_.empty()) file_.reset();
}

}  // namespace ossuary::index
