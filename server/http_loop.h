#pragma once

#include <cstdint>
#include <list>
#include <utility>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "server/http_session.h"
#include "server/http_shared.h"
#include "server/http_workers.h"

namespace ossuary::server {

/// The thread that accepts connections and moves their sessions on whenever a socket is ready or
/// time is up. What takes time goes to the workers, which give it back.
class HttpLoop {
public:
    /// @param listener  a listening socket; closed here
    HttpLoop(HttpShared& shared, int listener);
    ~HttpLoop();
    HttpLoop(const HttpLoop&) = delete;
    HttpLoop& operator=(const HttpLoop&) = delete;

    /// Until the server stops and the last session has ended. Errors: internal.
    Result<void> run();

private:
    using Wants = Session::Wants;
    struct Entry {
        Entry(HttpShared& shared, int socket) : session(shared, socket) {}
        Session session;
        bool with_worker = false;
        bool ended = false;
        std::list<Entry>::iterator self;
    };

    void watch(int socket, int operation, std::uint32_t events, void* what);
    void on_event(void* what);
    void accept_all();
    void rest_from_accepting();
    void open(int socket);
    /// Moves a session on by `call` and does what it wants then.
    template <typename Call>
    void move_on(Entry& entry, const Call& call);
    void hand_to_worker(Entry& entry);
    void take_back();
    void end(Entry& entry);
    /// Ends the session with the least claim; false when all have a good one.
    bool make_room();
    void look_at_deadlines(Clock::time_point now);
    void look_at_orders();

    HttpShared& shared_;
    int listener_;
    int poll_;
    bool accepting_ = false;
    bool stopping_ = false;
    bool cancelled_ = false;
    Clock::time_point accept_again_;
    Clock::time_point next_look_;
    std::list<Entry> entries_;
    std::list<Entry> ended_;  ///< kept until no event of this round can name them
    Mutex mutex_;
    std::vector<std::pair<Entry*, Wants>> returned_ OSSUARY_GUARDED_BY(mutex_);
    HttpWorkers workers_;  ///< last, so that they end first
};

}  // namespace ossuary::server
