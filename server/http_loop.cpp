#include "server/http_loop.h"

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>

namespace ossuary::server {
namespace {

/// How exactly deadlines are kept.
constexpr auto kLook = std::chrono::milliseconds(50);

/// A session that waits makes one event; one that a worker has makes none.
constexpr std::uint32_t kOnce = EPOLLONESHOT;

Problem shutting_down() {
    return problem(RequestFault::kShuttingDown, "The server is shutting down.");
}

}  // namespace

HttpLoop::HttpLoop(HttpShared& shared, int listener)
    : shared_(shared),
      listener_(listener),
      poll_(epoll_create1(EPOLL_CLOEXEC)),
      workers_(shared.options.threads, shared.options.max_waiting) {
    fcntl(listener_, F_SETFL, fcntl(listener_, F_GETFL, 0) | O_NONBLOCK);
}

HttpLoop::~HttpLoop() {
    if (listener_ >= 0) close(listener_);
    if (poll_ >= 0) close(poll_);
}

Result<void> HttpLoop::run() {
    if (poll_ < 0 || shared_.wake < 0) {
        return {ErrorCode::kInternal, std::string("cannot watch sockets: ") + std::strerror(errno)};
    }
    watch(shared_.wake, EPOLL_CTL_ADD, EPOLLIN, &shared_);
    std::array<epoll_event, 64> events;
    look_at_orders();
    look_at_deadlines(Clock::now());
    while (!stopping_ || !entries_.empty()) {
        const bool idle = entries_.empty() && accepting_;
        const int count = epoll_wait(poll_, events.data(), static_cast<int>(events.size()),
                                     idle ? -1 : static_cast<int>(kLook.count()));
        if (count < 0 && errno != EINTR) {
            return {ErrorCode::kInternal,
                    std::string("cannot wait for sockets: ") + std::strerror(errno)};
        }
        for (int i = 0; i < count; ++i) on_event(events[static_cast<std::size_t>(i)].data.ptr);
        take_back();
        look_at_orders();
        if (const auto now = Clock::now(); now >= next_look_) look_at_deadlines(now);
        ended_.clear();
    }
    return {};
}

void HttpLoop::watch(int socket, int operation, std::uint32_t events, void* what) {
    epoll_event event{};
    event.events = events;
    event.data.ptr = what;
    epoll_ctl(poll_, operation, socket, &event);
}

void HttpLoop::on_event(void* what) {
    if (what == &shared_) {
        eventfd_t ignored = 0;
        eventfd_read(shared_.wake, &ignored);
    } else if (what == &listener_) {
        accept_all();
    } else if (auto& entry = *static_cast<Entry*>(what); !entry.ended && !entry.with_worker) {
        move_on(entry, [](Session& session) { return session.resume(); });
    }
}

void HttpLoop::accept_all() {
    // No more than so many at a time, for those who are connected already.
    for (int i = 0; i < 64 && accepting_; ++i) {
        const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (socket >= 0) {
            open(socket);
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            return;
        } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
            make_room();
            rest_from_accepting();
        }
    }
}

/// Where a connection cannot be accepted, the next attempt fails likewise until something has been
/// closed.
void HttpLoop::rest_from_accepting() {
    watch(listener_, EPOLL_CTL_DEL, 0, nullptr);
    accepting_ = false;
    accept_again_ = Clock::now() + kLook;
}

void HttpLoop::open(int socket) {
    bool room = shared_.connections < shared_.options.max_connections;
    if (!room) {
        take_back();  // those that have just been answered have the least claim
        room = make_room();
    }
    try {
        entries_.emplace_back(shared_, socket);
    } catch (const std::exception&) {
        close(socket);
        return;
    }
    Entry& entry = entries_.back();
    entry.self = std::prev(entries_.end());
    ++shared_.connections;
    watch(socket, EPOLL_CTL_ADD, kOnce, &entry);
    move_on(entry,
            [room](Session& session) { return room ? session.resume() : session.turn_away(); });
}

template <typename Call>
void HttpLoop::move_on(Entry& entry, const Call& call) {
    Wants wants = Wants::kEnd;
    try {
        wants = call(entry.session);
    } catch (const std::exception&) {  // no memory even for saying so
    }
    switch (wants) {
        case Wants::kReadable:
            watch(entry.session.socket(), EPOLL_CTL_MOD, EPOLLIN | kOnce, &entry);
            return;
        case Wants::kWritable:
            watch(entry.session.socket(), EPOLL_CTL_MOD, EPOLLOUT | kOnce, &entry);
            return;
        case Wants::kWorker:
            hand_to_worker(entry);
            return;
        case Wants::kEnd:
            end(entry);
            return;
    }
}

void HttpLoop::hand_to_worker(Entry& entry) {
    const auto task = [this, &entry] {
        Wants wants = Wants::kEnd;
        try {
            wants = entry.session.work();
        } catch (const std::exception&) {  // no memory even for saying so
        }
        {
            const Lock lock(mutex_);
            returned_.emplace_back(&entry, wants);
        }
        eventfd_write(shared_.wake, 1);
    };
    entry.with_worker = true;
    if (workers_.enqueue(task, entry.session.urgent())) return;
    entry.with_worker = false;
    move_on(entry, [](Session& session) { return session.turn_away(); });
}

void HttpLoop::take_back() {
    std::vector<std::pair<Entry*, Wants>> returned;
    {
        const Lock lock(mutex_);
        returned.swap(returned_);
    }
    for (const auto& [entry, wants] : returned) {
        entry->with_worker = false;
        move_on(*entry, [wants = wants](Session&) { return wants; });
    }
}

void HttpLoop::end(Entry& entry) {
    entry.ended = true;
    --shared_.connections;
    ended_.splice(ended_.end(), entries_, entry.self);
}

bool HttpLoop::make_room() {
    const auto now = Clock::now();
    while (true) {
        Entry* least = nullptr;
        Claim least_claim;
        for (Entry& entry : entries_) {
            if (entry.with_worker) continue;
            const Claim claim = entry.session.claim(now);
            if (claim.rank == Claim::kGood) continue;
            if (least == nullptr || claim.rank < least_claim.rank ||
                (claim.rank == least_claim.rank && claim.since < least_claim.since)) {
                least = &entry;
                least_claim = claim;
            }
        }
        if (least == nullptr) return false;
        move_on(*least, [](Session& session) {
            return session.give_way(problem(RequestFault::kOverloaded,
                                            "Others wait for the place of this connection."));
        });
        if (least->ended) return true;
    }
}

void HttpLoop::look_at_deadlines(Clock::time_point now) {
    next_look_ = now + kLook;
    if (!accepting_ && !stopping_ && now >= accept_again_) {
        accepting_ = true;
        watch(listener_, EPOLL_CTL_ADD, EPOLLIN, &listener_);
    }
    for (auto next = entries_.begin(); next != entries_.end();) {
        Entry& entry = *next++;
        if (entry.with_worker || now < entry.session.deadline()) continue;
        move_on(entry, [](Session& session) { return session.time_up(); });
    }
}

void HttpLoop::look_at_orders() {
    if (!stopping_ && shared_.stopping) {
        stopping_ = true;
        accepting_ = false;
        close(listener_);
        listener_ = -1;
        for (auto next = entries_.begin(); next != entries_.end();) {
            Entry& entry = *next++;
            if (!entry.with_worker) move_on(entry, [](Session& session) { return session.stop(); });
        }
    }
    if (!cancelled_ && shared_.cancelled) cancelled_ = true;
    if (!cancelled_ || !stopping_) return;
    for (auto next = entries_.begin(); next != entries_.end();) {
        Entry& entry = *next++;
        if (entry.with_worker) continue;
        move_on(entry, [](Session& session) { return session.give_way(shutting_down()); });
    }
}

}  // namespace ossuary::server
