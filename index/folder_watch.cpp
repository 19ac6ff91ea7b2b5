#include "index/folder_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "index/model_files.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kChanges = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM |
                                   IN_MOVED_TO | IN_ATTRIB | IN_DELETE_SELF | IN_MOVE_SELF |
                                   IN_ONLYDIR | IN_EXCL_UNLINK;

class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() {
        if (number_ >= 0) close(number_);
    }
    [[nodiscard]] int get() const { return number_; }

private:
    int number_;
};

/// File systems whose changes may be made elsewhere (linux/magic.h, and statfs(2)).
bool is_shared(const fs::path& folder) {
    struct statfs info {};
    if (statfs(folder.c_str(), &info) != 0) return false;
    constexpr std::array<std::uint32_t, 10> kShared = {
        0x6969,      // NFS
        0x517B,      // SMB
        0xFF534D42,  // CIFS
        0xFE534D42,  // SMB 2
        0x65735546,  // FUSE: sshfs, …
        0x00C36400,  // Ceph
        0x5346414F,  // AFS
        0x01021997,  // 9P
        0x786F4256,  // VirtualBox' shared folders
        0x47504653,  // GPFS
    };
    return std::ranges::find(kShared, static_cast<std::uint32_t>(info.f_type)) != kShared.end();
}

int milliseconds_until(Clock::time_point time) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(time - Clock::now()).count();
    return static_cast<int>(std::clamp<std::int64_t>(left, 0, 3'600'000));
}

}  // namespace

struct FolderWatch::Impl {
    std::vector<fs::path> roots;
    FolderWatchOptions options;
    Descriptor inotify, woken;
    std::map<int, fs::path> folders;  ///< by watch
    std::set<int> seen;               ///< watches of this refresh
    std::set<int>
        entered;  ///< of these, where what is below was looked at: each once, however linked
    std::vector<fs::path> untold;
    Clock::time_point next_rescan;

    void add_root(const fs::path& root, const std::stop_token& stop);
    void add_folder(const fs::path& folder, const std::stop_token& stop);
    /// The folder's watch; none where there can be none.
    std::optional<int> watch(const fs::path& folder);
    [[nodiscard]] bool counts(const inotify_event& event) const;
    /// Takes all that has been told; whether some of it counts.
    bool drain();
    /// Waits until something is told, the time has come or a stop is wanted; whether to go on.
    bool sleep_until(Clock::time_point time, const std::stop_token& stop);
};

void FolderWatch::Impl::add_root(const fs::path& root, const std::stop_token& stop) {
    std::error_code fault;
    if (fs::is_directory(root, fault)) {
        add_folder(root, stop);
    } else if (const fs::path parent = root.parent_path(); fs::is_directory(parent, fault)) {
        watch(parent);  // a file is told of by its folder, as is a folder that will be there
    }
}

void FolderWatch::Impl::add_folder(const fs::path& top, const std::stop_token& stop) {
    std::vector<fs::path> open = {top};
    while (!open.empty() && !stop.stop_requested()) {
        const fs::path folder = std::move(open.back());
        open.pop_back();
        const auto number = watch(folder);
        if (!number || !entered.insert(*number).second) continue;
        std::error_code fault;
        for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
             entry.increment(fault)) {
            std::error_code ignored;
            if (!is_hidden_name(entry->path().filename().native()) &&
                entry->is_directory(ignored)) {
                open.push_back(entry->path());
            }
        }
    }
}

std::optional<int> FolderWatch::Impl::watch(const fs::path& folder) {
    const int number = inotify_add_watch(inotify.get(), folder.c_str(), kChanges);
    if (number < 0) {
        if (errno == ENOSPC) untold.push_back(folder);
        return std::nullopt;
    }
    if (seen.insert(number).second) {
        folders[number] = folder;
        if (is_shared(folder)) untold.push_back(folder);
    }
    return number;
}

bool FolderWatch::Impl::counts(const inotify_event& event) const {
    if ((event.mask & IN_Q_OVERFLOW) != 0) return true;
    if ((event.mask & IN_IGNORED) != 0 || event.len == 0) {
        return (event.mask & (IN_DELETE_SELF | IN_MOVE_SELF)) != 0;
    }
    const std::string_view name = event.name;
    if (is_hidden_name(name)) return false;
    const auto folder = folders.find(event.wd);
    if (folder == folders.end()) return true;
    const fs::path path = folder->second / name;
    return std::ranges::none_of(options.ignored, [&](const fs::path& file) {
        const std::string_view whole = path.native();
        if (!whole.starts_with(file.native())) return false;
        const std::string_view ending = whole.substr(file.native().size());
        return ending.empty() || ending.front() == '-';
    });
}

bool FolderWatch::Impl::drain() {
    alignas(inotify_event) std::array<char, 16384> buffer;
    bool found = false;
    for (;;) {
        const ssize_t size = read(inotify.get(), buffer.data(), buffer.size());
        if (size <= 0) return found;
        for (const char* at = buffer.data(); at < buffer.data() + size;) {
            const auto* event = reinterpret_cast<const inotify_event*>(at);
            found = counts(*event) || found;
            at += sizeof(inotify_event) + event->len;
        }
    }
}

bool FolderWatch::Impl::sleep_until(Clock::time_point time, const std::stop_token& stop) {
    if (stop.stop_requested()) return false;
    std::array<pollfd, 2> waited = {{{inotify.get(), POLLIN, 0}, {woken.get(), POLLIN, 0}}};
    poll(waited.data(), waited.size(), milliseconds_until(time));
    return !stop.stop_requested();
}

FolderWatch::FolderWatch(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FolderWatch::FolderWatch(FolderWatch&&) noexcept = default;
FolderWatch& FolderWatch::operator=(FolderWatch&&) noexcept = default;
FolderWatch::~FolderWatch() = default;

Result<FolderWatch> FolderWatch::open(std::vector<fs::path> roots, FolderWatchOptions options) {
    auto impl = std::make_unique<Impl>();
    for (const fs::path& root : roots) impl->roots.push_back(index_path(root));
    for (fs::path& file : options.ignored) file = index_path(file);
    impl->options = std::move(options);
    impl->inotify = Descriptor(inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    impl->woken = Descriptor(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
    if (impl->inotify.get() < 0 || impl->woken.get() < 0) {
        return {ErrorCode::kInternal,
                std::string("folders cannot be watched: ") + std::strerror(errno)};
    }
    impl->next_rescan = Clock::now() + impl->options.rescan;
    return FolderWatch(std::move(impl));
}

void FolderWatch::refresh(const std::stop_token& stop) {
    impl_->seen.clear();
    impl_->entered.clear();
    impl_->untold.clear();
    for (const fs::path& root : impl_->roots) impl_->add_root(root, stop);
    std::erase_if(impl_->folders,
                  [&](const auto& folder) { return !impl_->seen.contains(folder.first); });
    impl_->next_rescan = Clock::now() + impl_->options.rescan;
}

FolderWatch::Reason FolderWatch::wait(const std::stop_token& stop) {
    const std::stop_callback wake(stop, [this] { eventfd_write(impl_->woken.get(), 1); });
    while (!impl_->drain()) {
        if (!impl_->sleep_until(impl_->next_rescan, stop)) return Reason::kStop;
        if (Clock::now() >= impl_->next_rescan) return Reason::kRescan;
    }
    const Clock::time_point end = Clock::now() + impl_->options.at_most;
    Clock::time_point quiet = Clock::now() + impl_->options.settle;
    while (Clock::now() < std::min(quiet, end)) {
        if (!impl_->sleep_until(std::min(quiet, end), stop)) return Reason::kStop;
        if (impl_->drain()) quiet = Clock::now() + impl_->options.settle;
    }
    return Reason::kChange;
}

const std::vector<fs::path>& FolderWatch::untold() const { return impl_->untold; }

}  // namespace ossuary::index
