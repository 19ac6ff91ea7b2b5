#include "server/http_session.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "server/http_library.h"
#include "server/response_head.h"

namespace ossuary::server {
namespace {

/// Leaves of a path what is below a folder; of the folder itself, nothing.
void take_off(std::string& path, std::string_view folder) {
    if (folder.empty() || !path.starts_with(folder)) return;
    if (path.size() == folder.size() || path[folder.size()] == '/') path.erase(0, folder.size());
}

using enum RequestFault;
using Io = Connection::Io;

constexpr std::string_view kHeadEnd = "\r\n\r\n";
/// Below this, compressing costs more than it saves.
constexpr std::size_t kCompressFrom = 1400;

bool is_request_id(std::string_view text) {
    return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '.' || c == '_' || c == '-';
    });
}

}  // namespace

bool Session::BodyRoom::take(std::size_t bytes) {
    const std::size_t before = shared_.body_bytes.fetch_add(bytes);
    bytes_ = bytes;
    return before + bytes <= std::max(shared_.options.max_bodies, shared_.options.max_body);
}

Session::Session(HttpShared& shared, int socket) : shared_(shared), connection_(socket) {
    enter(Phase::kHead, shared_.options.head_timeout);
}

void Session::enter(Phase phase, Clock::duration patience) {
    phase_ = phase;
    since_ = moved_ = Clock::now();
    deadline_ = since_ + patience;
}

Session::Wants Session::resume() {
    switch (phase_) {
        case Phase::kHead:
            return read_head();
        case Phase::kBody:
            return read_body();
        case Phase::kAnswer:
            return write_answer();
        case Phase::kLinger:
            return linger();
        case Phase::kJudge:
        case Phase::kHandle:
            break;
    }
    return Wants::kWorker;
}

Session::Wants Session::work() {
    std::optional<Response> settled;
    if (phase_ == Phase::kJudge) {
        settled = judge();
        if (!settled && turn_->body_pending) return begin_body();
    }
    return begin_answer(settled ? *std::move(settled) : handle());
}

Session::Wants Session::time_up() {
    switch (phase_) {
        case Phase::kHead:
            if (!head_begun_) return end_unless_begun();
            return refuse_head(problem(kRequestTimeout, "The header did not arrive in time."));
        case Phase::kBody:
            return refuse(problem(kRequestTimeout, "The body did not arrive in time."));
        case Phase::kAnswer:
            return finish_turn(false);
        default:
            return Wants::kEnd;
    }
}

Session::Wants Session::turn_away() {
    shared_.handler.refused();  // before the answer: who has that finds it counted
    const Problem why = problem(kOverloaded, "Too many requests are waiting.");
    return turn_ ? refuse(why) : refuse_head(why);
}

Session::Wants Session::give_way(const Problem& why) {
    switch (phase_) {
        case Phase::kHead:
            if (!head_begun_) return end_unless_begun();
            refuse_head(why);
            return Wants::kEnd;
        case Phase::kBody:
            refuse(why);
            return Wants::kEnd;
        case Phase::kAnswer:
            return finish_turn(false);
        default:
            return Wants::kEnd;
    }
}

Session::Wants Session::stop() { return phase_ == Phase::kHead ? end_unless_begun() : resume(); }

/// What has arrived up to now is not dropped.
Session::Wants Session::end_unless_begun() {
    const Wants wants = read_head();
    return wants == Wants::kReadable && !head_begun_ ? Wants::kEnd : wants;
}

bool Session::hardly_moves(Clock::time_point now) const {
    const HttpOptions& options = shared_.options;
    if (now - since_ < options.slow_after) return false;
    if (now - moved_ >= options.slow_after) return true;
    const std::size_t bytes =
        phase_ == Phase::kBody ? turn_->request.body.size() : turn_->exchange.bytes_out;
    return static_cast<double>(bytes) <
           options.slow_bytes_per_second * std::chrono::duration<double>(now - since_).count();
}

Claim Session::claim(Clock::time_point now) const {
    switch (phase_) {
        case Phase::kHead:
            if (head_begun_) return {Claim::kSlowHead, since_};
            return {turns_ == 0 ? Claim::kSilent : Claim::kIdle, since_};
        case Phase::kBody:
        case Phase::kAnswer:
            return {hardly_moves(now) ? Claim::kSlow : Claim::kGood, since_};
        case Phase::kLinger:
            return {Claim::kAnswered, since_};
        default:
            return {Claim::kGood, since_};
    }
}

Session::Wants Session::read_head() {
    const std::size_t most = shared_.options.head.max_bytes;
    while (true) {
        const std::string_view held = connection_.buffered();
        if (!held.empty() && !head_begun_) {
            head_begun_ = true;
            enter(Phase::kHead, shared_.options.head_timeout);
        }
        const std::size_t end =
            held.find(kHeadEnd, searched_ - std::min(searched_, kHeadEnd.size() - 1));
        if (end != std::string_view::npos && end + kHeadEnd.size() <= most) {
            return begin_turn(held.substr(0, end + kHeadEnd.size()));
        }
        if (held.size() >= most) {
            return refuse_head(
                held.find("\r\n") == std::string_view::npos
                    ? problem(kUriTooLong, "The request line does not end.")
                    : problem(kFieldsTooLarge,
                              "The header has more than " + std::to_string(most) + " bytes."));
        }
        searched_ = held.size();
        switch (connection_.fill(most)) {
            case Io::kDone:
                break;
            case Io::kWait:
                return Wants::kReadable;
            case Io::kEnded:  // nobody to answer
                return Wants::kEnd;
        }
    }
}

Session::Wants Session::begin_turn(std::string_view head_bytes) {
    turn_.emplace(shared_);
    turn_->begun = since_;
    ++turns_;
    turn_->last = turns_ == shared_.options.max_requests;
    turn_->exchange.bytes_in = head_bytes.size();
    auto head = check_head(head_bytes, shared_.options.head);
    if (!head) turn_->exchange.target = loggable_target(head_bytes);
    connection_.consume(head_bytes.size());
    searched_ = 0;
    if (!head) return refuse(head.error());

    RequestHead& known = turn_->request.head = *std::move(head);
    turn_->exchange.method = known.method;
    turn_->exchange.target = known.path;
    take_off(known.path, shared_.options.base_path);
    turn_->body_pending = known.content_length > 0;
    turn_->request.id = shared_.new_id();
    if (const std::string wished = known.header("X-Request-Id"); is_request_id(wished)) {
        turn_->request.id = wished;
    }
    turn_->request.remote_address = connection_.remote_address();
    urgent_ = shared_.handler.is_urgent(known);
    phase_ = Phase::kJudge;
    return Wants::kWorker;
}

std::optional<Response> Session::judge() {
    const RequestHead& head = turn_->request.head;
    if (auto answer = shared_.handler.admit(head, turn_->request.id)) return answer;
    if (!turn_->body_pending) return std::nullopt;
    const auto refused = [&](const Problem& why) {
        turn_->last = true;
        return problem_response(why);
    };
    const std::size_t most = shared_.options.max_body;
    if (head.method != "POST") {
        return refused(problem(kBodyUnexpected, head.method + " takes no body."));
    }
    if (head.content_length > most) {
        return refused(problem(kPayloadTooLarge,
                               "The body has " + std::to_string(head.content_length) +
                                   " bytes; at most " + std::to_string(most) + " are taken."));
    }
    if (!turn_->room.take(static_cast<std::size_t>(head.content_length))) {
        return refused(problem(kOverloaded, "Too many uploads are under way."));
    }
    return std::nullopt;
}

Session::Wants Session::begin_body() {
    const auto size = static_cast<std::size_t>(turn_->request.head.content_length);
    try {
        turn_->request.body.reserve(size);
    } catch (const std::exception&) {
        return refuse(problem({ErrorCode::kOutOfMemory,
                               "no memory for a body of " + std::to_string(size) + " bytes"}));
    }
    enter(Phase::kBody, shared_.options.request_timeout);
    if (turn_->request.head.expects_continue) {
        std::string_view interim = "HTTP/1.1 100 Continue\r\n\r\n";
        if (connection_.write(interim) != Io::kDone) return Wants::kEnd;
    }
    return read_body();
}

Session::Wants Session::read_body() {
    std::string& body = turn_->request.body;
    const std::size_t before = body.size();
    const Io outcome =
        connection_.read_into(body, static_cast<std::size_t>(turn_->request.head.content_length));
    if (body.size() > before) moved_ = Clock::now();
    switch (outcome) {
        case Io::kWait:
            return Wants::kReadable;
        case Io::kEnded:
            return refuse(problem(kBodyIncomplete, "The body is shorter than announced."));
        case Io::kDone:
            break;
    }
    turn_->body_pending = false;
    turn_->exchange.bytes_in += body.size();
    phase_ = Phase::kHandle;
    return Wants::kWorker;
}

Response Session::handle() {
    phase_ = Phase::kHandle;
    const Watchdog::Watch watch(shared_.watchdog, Clock::now() + shared_.options.request_timeout,
                                connection_.socket());
    turn_->request.stop = watch.token();
    // The text of an exception may hold anything: it goes to the log alone.
    try {
        return shared_.handler.handle(turn_->request);
    } catch (const std::bad_alloc&) {
        return problem_response(problem({ErrorCode::kOutOfMemory, "while making the answer"}));
    } catch (const std::exception& exception) {
        return problem_response(problem({ErrorCode::kInternal, exception.what()}));
    } catch (...) {
        return problem_response(problem({ErrorCode::kInternal, "an exception without a text"}));
    }
}

Response Session::problem_response(const Problem& why) const {
    return to_response(why, turn_->request.head.path, turn_->request.id);
}

/// Ends the connection: what follows on it can no longer be told apart.
Session::Wants Session::refuse(const Problem& why) {
    if (turn_->request.id.empty()) turn_->request.id = shared_.new_id();
    turn_->last = turn_->body_pending = true;
    return begin_answer(problem_response(why));
}

/// The same for a header that has not come to its end.
Session::Wants Session::refuse_head(const Problem& why) {
    turn_.emplace(shared_);
    turn_->begun = since_;
    turn_->exchange.target = loggable_target(connection_.buffered());
    turn_->exchange.bytes_in = connection_.buffered().size();
    return refuse(why);
}

Session::Wants Session::begin_answer(Response response) {
    Turn& turn = *turn_;
    const RequestHead& head = turn.request.head;
    shared_.handler.complete(response, head, turn.request.id);
    if (response.close || !head.keep_alive || turn.body_pending || shared_.ends_connections()) {
        turn.last = true;
    }
    turn.exchange.id = turn.request.id;
    turn.exchange.remote_address = connection_.remote_address();
    turn.exchange.status = response.status;
    turn.exchange.code = response.code;
    turn.exchange.cause = response.cause;
    turn.exchange.route = response.route;

    Fields fields;
    turn.body = std::move(response.body);
    if (!response.content_type.empty() && !turn.body.empty()) {
        fields.push_back({"Vary", "Accept-Encoding"});
        if (turn.body.size() >= kCompressFrom && is_compressible(response.content_type) &&
            takes_gzip(head.header("Accept-Encoding"))) {
            if (auto packed = gzip(turn.body)) {
                turn.body = *std::move(packed);
                fields.push_back({"Content-Encoding", "gzip"});
            }
        }
    }
    if (turn.last) {
        fields.push_back({"Connection", "close"});
    } else if (head.minor_version == 0) {
        fields.push_back({"Connection", "keep-alive"});
    }
    turn.head = response_head(response, turn.body.size(), fields);
    turn.head_rest = turn.head;
    if (head.method != "HEAD") turn.body_rest = turn.body;
    enter(Phase::kAnswer, shared_.options.request_timeout);
    return write_answer();
}

Session::Wants Session::write_answer() {
    for (std::string_view* rest : {&turn_->head_rest, &turn_->body_rest}) {
        const std::size_t before = rest->size();
        const Io outcome = connection_.write(*rest);
        if (rest->size() < before) moved_ = Clock::now();
        turn_->exchange.bytes_out += before - rest->size();
        if (outcome == Io::kWait) return Wants::kWritable;
        if (outcome == Io::kEnded) return finish_turn(false);
    }
    return finish_turn(true);
}

Session::Wants Session::finish_turn(bool sent) {
    turn_->exchange.milliseconds =
        std::chrono::duration<double, std::milli>(Clock::now() - turn_->begun).count();
    shared_.handler.finished(turn_->exchange);
    const bool last = turn_->last;
    const bool refused_body = turn_->body_pending;
    turn_.reset();
    urgent_ = false;
    head_begun_ = false;
    if (!sent) {
        enter(Phase::kLinger, Clock::duration::zero());
        return Wants::kEnd;
    }
    if (!last) return next_turn();
    // Closing at once would reset the connection under an answer that is still on its way to a
    // client which has sent more than was read.
    connection_.end_output();
    constexpr auto kShort = std::chrono::milliseconds(250);
    enter(Phase::kLinger, shared_.stopping && !refused_body
                              ? std::min(shared_.options.linger, kShort)
                              : shared_.options.linger);
    return linger();
}

Session::Wants Session::next_turn() {
    enter(Phase::kHead, shared_.options.keep_alive_timeout);
    return read_head();
}

Session::Wants Session::linger() {
    return connection_.swallow() == Io::kEnded ? Wants::kEnd : Wants::kReadable;
}

}  // namespace ossuary::server
