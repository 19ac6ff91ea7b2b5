#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "server/connection.h"
#include "server/http_shared.h"

namespace ossuary::server {

/// How good a claim a connection has to its place; those with the lower rank give way first, of
/// equal ranks those that have been so for longer.
struct Claim {
    enum Rank {
        kAnswered,  ///< has had its last answer and has only to go
        kSilent,    ///< has not sent a byte
        kIdle,      ///< between two requests
        kSlowHead,  ///< a part of a request line and header has come
        kSlow,      ///< a body or an answer that hardly moves
        kGood,      ///< does not give way
    };
    Rank rank = kGood;
    Clock::time_point since;
};

/// One connection on its way through its requests: receiving a header, judging it, receiving a
/// body, having it handled, sending the answer. It never waits: each call goes on as far as it can
/// and says what it wants next. One thread at a time has it.
class Session {
public:
    enum class Wants {
        kReadable,  ///< `resume` when the socket can be read, or `time_up` at `deadline`
        kWritable,  ///< the same when it can be written
        kWorker,    ///< `work` on a thread that may take its time
        kEnd,       ///< nothing more
    };

    Session(HttpShared& shared, int socket);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    Wants resume();
    Wants work();
    Wants time_up();
    /// No worker will have it: answers that and ends.
    Wants turn_away();
    /// Its place is needed: tells a client that has begun to send something why, and ends. It goes
    /// on where a request has arrived just now.
    Wants give_way(const Problem& why);
    /// The server stops: ends a connection on which nothing has come.
    Wants stop();

    [[nodiscard]] Clock::time_point deadline() const { return deadline_; }
    [[nodiscard]] Claim claim(Clock::time_point now) const;
    /// Whether what it wants a worker for must not wait behind others.
    [[nodiscard]] bool urgent() const { return urgent_; }
    [[nodiscard]] int socket() const { return connection_.socket(); }

private:
    enum class Phase { kHead, kJudge, kBody, kHandle, kAnswer, kLinger };

    /// Room for a body in memory, given back when destroyed.
    class BodyRoom {
    public:
        explicit BodyRoom(HttpShared& shared) : shared_(shared) {}
        ~BodyRoom() { shared_.body_bytes -= bytes_; }
        BodyRoom(const BodyRoom&) = delete;
        BodyRoom& operator=(const BodyRoom&) = delete;
        bool take(std::size_t bytes);

    private:
        HttpShared& shared_;
        std::size_t bytes_ = 0;
    };

    /// One request and its answer.
    struct Turn {
        explicit Turn(HttpShared& shared) : room(shared) {}

        Request request;
        BodyRoom room;
        bool body_pending = false;  ///< there is a body which has not been read to its end
        bool last = false;          ///< the connection ends after this turn
        std::string head;           ///< of the answer
        std::string body;
        std::string_view head_rest;  ///< yet to be sent
        std::string_view body_rest;
        Clock::time_point begun;
        Exchange exchange;
    };

    Wants read_head();
    Wants begin_turn(std::string_view head_bytes);
    /// The answer where it does not depend on the body.
    std::optional<Response> judge();
    Wants begin_body();
    Wants read_body();
    Response handle();
    Wants refuse(const Problem& why);
    Wants refuse_head(const Problem& why);
    Wants end_unless_begun();
    Wants begin_answer(Response response);
    Wants write_answer();
    Wants finish_turn(bool sent);
    Wants next_turn();
    Wants linger();
    void enter(Phase phase, Clock::duration patience);
    [[nodiscard]] Response problem_response(const Problem& why) const;
    [[nodiscard]] bool hardly_moves(Clock::time_point now) const;

    HttpShared& shared_;
    Connection connection_;
    Phase phase_ = Phase::kHead;
    Clock::time_point deadline_;
    Clock::time_point since_;  ///< of the phase
    Clock::time_point moved_;  ///< when bytes of a body or an answer went through last
    bool head_begun_ = false;
    bool urgent_ = false;
    std::size_t searched_ = 0;  ///< of the buffer, for the end of the header
    std::size_t turns_ = 0;
    std::optional<Turn> turn_;
};

}  // namespace ossuary::server
