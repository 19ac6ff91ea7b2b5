#include "server/http_session.h"

#include <httplib.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <optional>
#include <utility>

namespace ossuary::server {
namespace {

using enum RequestFault;

/// Below this, compressing costs more than it saves.
constexpr std::size_t kCompressFrom = 1400;

/// What the library reads and writes: first the head that we write for it, then the connection.
class ReplayStream : public httplib::Stream {
public:
    ReplayStream(Connection& connection, std::string head)
        : connection_(connection), head_(std::move(head)) {}

    bool is_readable() const override { return true; }
    bool is_writable() const override { return true; }
    ssize_t read(char* data, size_t size) override {
        if (position_ == head_.size()) return connection_.read(data, size);
        const std::size_t count = std::min(size, head_.size() - position_);
        head_.copy(data, count, position_);
        position_ += count;
        return static_cast<ssize_t>(count);
    }
    ssize_t write(const char* data, size_t size) override { return connection_.write(data, size); }
    void get_remote_ip_and_port(std::string& address, int& port) const override {
        address = connection_.remote_address();
        port = connection_.remote_port();
    }
    void get_local_ip_and_port(std::string& address, int& port) const override {
        address = connection_.local_address();
        port = connection_.local_port();
    }
    socket_t socket() const override { return connection_.socket(); }

private:
    Connection& connection_;
    std::string head_;
    std::size_t position_ = 0;
};

/// Room for a body in memory, given back when destroyed.
class BodyRoom {
public:
    explicit BodyRoom(HttpShared& shared) : shared_(shared) {}
    ~BodyRoom() { shared_.body_bytes -= bytes_; }
    BodyRoom(const BodyRoom&) = delete;
    BodyRoom& operator=(const BodyRoom&) = delete;

    bool take(std::size_t bytes) {
        const std::size_t before = shared_.body_bytes.fetch_add(bytes);
        bytes_ = bytes;
        return before + bytes <= std::max(shared_.options.max_bodies, shared_.options.max_body);
    }

private:
    HttpShared& shared_;
    std::size_t bytes_ = 0;
};

/// One request on its way through a connection.
struct Turn {
    explicit Turn(HttpShared& shared) : room(shared) {}

    Request request;
    std::optional<Response> settled;  ///< the answer, where it does not depend on the body
    BodyRoom room;
    bool body_pending = false;  ///< there is a body which has not been read to its end
    bool last = false;          ///< the connection ends after this turn
    Exchange exchange;
};

bool is_request_id(std::string_view text) {
    return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '.' || c == '_' || c == '-';
    });
}

std::string http_date() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    constexpr std::array kDays = {"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
    constexpr std::array kMonths = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                    "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    std::array<char, 40> text{};
    const int size = std::snprintf(text.data(), text.size(), "%s, %02d %s %04d %02d:%02d:%02d GMT",
                                   kDays[static_cast<std::size_t>(utc.tm_wday)], utc.tm_mday,
                                   kMonths[static_cast<std::size_t>(utc.tm_mon)],
                                   utc.tm_year + 1900, utc.tm_hour, utc.tm_min, utc.tm_sec);
    return {text.data(), static_cast<std::size_t>(size)};
}

bool takes_gzip(const RequestHead& head) {
    const std::string value = head.header("Accept-Encoding");
    const std::size_t at = value.find("gzip");
    return at != std::string::npos && value.compare(at, 8, "gzip;q=0") != 0;
}

/// Serves one connection. It borrows the library's reading of bodies and writing of answers, which
/// are methods of its server class; this one never listens.
class Session : public httplib::Server {
public:
    Session(HttpShared& shared, Connection& connection) : shared_(shared), connection_(connection) {
        set_payload_max_length(shared.options.max_body);
        set_pre_routing_handler([this](const httplib::Request&, httplib::Response& out) {
            if (turn_->body_pending && !turn_->settled) return HandlerResponse::Unhandled;
            deliver(turn_->settled ? *std::move(turn_->settled) : handle(), out);
            return HandlerResponse::Handled;
        });
        Post("/", [this](const httplib::Request&, httplib::Response& out,
                         const httplib::ContentReader& reader) {
            deliver(read_body(reader) ? handle() : body_problem(), out);
        });
        set_exception_handler(
            [this](const httplib::Request&, httplib::Response& out, const std::exception_ptr&) {
                turn_->last = true;
                deliver(refusal(problem({ErrorCode::kInternal, {}})), out);
            });
        set_post_routing_handler(
            [this](const httplib::Request&, httplib::Response& out) { finish_headers(out); });
    }

    void serve() {
        for (std::size_t n = 0; n < shared_.options.max_requests; ++n) {
            if (!wait_for_request(n == 0)) return;
            Turn turn(shared_);
            turn.last = n + 1 == shared_.options.max_requests;
            if (!serve_turn(turn)) return;
        }
    }

private:
    /// An idle connection makes room when others wait for a thread.
    bool wait_for_request(bool first) const {
        constexpr auto kLook = std::chrono::milliseconds(200);
        const auto patience =
            first ? shared_.options.head_timeout : shared_.options.keep_alive_timeout;
        const auto deadline = Clock::now() + patience;
        while (!connection_.has_buffered()) {
            const auto until = std::min(deadline, Clock::now() + kLook);
            if (connection_.wait_readable(until, shared_.wake)) return true;
            if (shared_.stopping || Clock::now() >= deadline) return false;
            if (!first && shared_.waiting > 0) return false;
        }
        return true;
    }

    bool serve_turn(Turn& turn) {
        turn_ = &turn;
        const auto start = Clock::now();
        const std::size_t read_before = connection_.bytes_read();
        const std::size_t written_before = connection_.bytes_written();
        if (!receive_head(turn)) return false;

        ReplayStream stream(connection_, library_head(turn));
        bool unused = false;
        const bool written = process_request(
            stream, false, unused, [this](httplib::Request& in) { library_request_ = &in; });
        library_request_ = nullptr;

        turn.exchange.bytes_in = connection_.bytes_read() - read_before;
        turn.exchange.bytes_out = connection_.bytes_written() - written_before;
        turn.exchange.milliseconds =
            std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        shared_.handler.finished(turn.exchange);
        if (written && turn.body_pending) connection_.linger(shared_.options.linger);
        return written && !turn.last && !turn.body_pending;
    }

    /// Reads and judges the head; false when there is nobody to answer.
    bool receive_head(Turn& turn) {
        turn.request.id = shared_.new_id();
        turn.request.remote_address = connection_.remote_address();
        turn.exchange.remote_address = turn.request.remote_address;
        const HeadLimits& limits = shared_.options.head;
        const auto outcome =
            connection_.read_head(limits.max_bytes, Clock::now() + shared_.options.head_timeout);
        turn.exchange.target = loggable_target(connection_.head());
        turn.exchange.id = turn.request.id;
        switch (outcome) {
            case Connection::Head::kClosed:
            case Connection::Head::kPartial:
                return false;
            case Connection::Head::kTimeout:
                settle(turn, problem(kRequestTimeout, "The header did not arrive in time."));
                return true;
            case Connection::Head::kTooLarge:
                settle(turn, connection_.head().find("\r\n") == std::string_view::npos
                                 ? problem(kUriTooLong, "The request line does not end.")
                                 : problem(kFieldsTooLarge, "The header has more than " +
                                                                std::to_string(limits.max_bytes) +
                                                                " bytes."));
                return true;
            case Connection::Head::kComplete:
                break;
        }
        auto head = check_head(connection_.head(), limits);
        connection_.consume_head();
        if (!head) {
            settle(turn, head.error());
        } else {
            turn.request.head = *std::move(head);
            judge(turn);
        }
        return true;
    }

    void judge(Turn& turn) {
        const RequestHead& head = turn.request.head;
        if (const std::string wished = head.header("X-Request-Id"); is_request_id(wished)) {
            turn.request.id = turn.exchange.id = wished;
        }
        turn.exchange.method = head.method;
        turn.exchange.target = head.path;
        turn.body_pending = head.content_length > 0;
        if (!head.keep_alive || shared_.stopping) turn.last = true;
        turn.settled = shared_.handler.admit(head, turn.request.id);
        if (turn.settled || !turn.body_pending) return;

        if (head.method != "POST") {
            settle(turn, problem(kBodyUnexpected, head.method + " takes no body."));
        } else if (head.content_length > shared_.options.max_body) {
            settle(turn, problem(kPayloadTooLarge,
                                 "The body has " + std::to_string(head.content_length) +
                                     " bytes; at most " + std::to_string(shared_.options.max_body) +
                                     " are taken."));
        } else if (!turn.room.take(static_cast<std::size_t>(head.content_length))) {
            settle(turn, problem(kOverloaded, "Too many uploads are under way."));
        }
    }

    /// An answer that ends the connection: what follows on it can no longer be told apart.
    void settle(Turn& turn, const Problem& why) {
        turn.last = true;
        turn.body_pending = true;
        turn.settled = refusal(why);
    }

    Response refusal(const Problem& why) const {
        return to_response(why, turn_->request.head.path, turn_->request.id);
    }

    /// The request as the library is to see it.
    std::string library_head(const Turn& turn) {
        const RequestHead& head = turn.request.head;
        const bool reads_body = turn.body_pending && !turn.settled;
        std::string text = reads_body ? "POST" : head.method == "HEAD" ? "HEAD" : "GET";
        text += " / HTTP/1.1\r\nHost: ossuary\r\n";
        if (takes_gzip(head)) text += "Accept-Encoding: gzip\r\n";
        if (reads_body) {
            text += "Content-Type: application/octet-stream\r\nContent-Length: " +
                    std::to_string(head.content_length) + "\r\n";
            connection_.set_read_deadline(Clock::now() + shared_.options.request_timeout);
            if (head.expects_continue) {
                constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
                connection_.set_write_deadline(Clock::now() + shared_.options.request_timeout);
                connection_.write(kContinue.data(), kContinue.size());
            }
        }
        return text + "\r\n";
    }

    bool read_body(const httplib::ContentReader& reader) {
        std::string& body = turn_->request.body;
        body.reserve(static_cast<std::size_t>(turn_->request.head.content_length));
        const bool complete = reader([&](const char* data, std::size_t size) {
            body.append(data, size);
            return true;
        });
        turn_->body_pending = !complete || body.size() != turn_->request.head.content_length;
        return !turn_->body_pending;
    }

    Response body_problem() {
        turn_->last = true;
        return refusal(connection_.timed_out()
                           ? problem(kRequestTimeout, "The body did not arrive in time.")
                           : problem(kBodyIncomplete, "The body is shorter than announced."));
    }

    Response handle() {
        const auto deadline = Clock::now() + shared_.options.request_timeout;
        const Watchdog::Watch watch(shared_.watchdog, deadline, connection_.socket());
        turn_->request.stop = watch.token();
        try {
            return shared_.handler.handle(turn_->request);
        } catch (const std::bad_alloc&) {
            return refusal(problem({ErrorCode::kOutOfMemory, {}}));
        } catch (...) {  // a bug; its text may hold anything and stays here
            return refusal(problem({ErrorCode::kInternal, {}}));
        }
    }

    void deliver(Response response, httplib::Response& out) {
        shared_.handler.complete(response, turn_->request.id);
        if (response.close || shared_.stopping) turn_->last = true;
        turn_->exchange.status = response.status;
        turn_->exchange.code = response.code;
        turn_->exchange.route = response.route;
        if (response.body.size() < kCompressFrom && library_request_ != nullptr) {
            library_request_->headers.erase("Accept-Encoding");
        }
        out.status = response.status;
        out.set_header("Date", http_date());
        for (const Field& field : response.headers) out.set_header(field.name, field.value);
        if (!response.content_type.empty()) {
            out.set_header("Content-Type", response.content_type);
            if (!response.body.empty()) out.set_header("Vary", "Accept-Encoding");
        }
        out.body = std::move(response.body);
        connection_.set_write_deadline(Clock::now() + shared_.options.request_timeout);
    }

    void finish_headers(httplib::Response& out) const {
        out.headers.erase("Keep-Alive");
        out.headers.erase("Accept-Ranges");
        out.headers.erase("Connection");
        if (turn_->last || turn_->body_pending) {
            out.set_header("Connection", "close");
        } else if (turn_->request.head.minor_version == 0) {
            out.set_header("Connection", "keep-alive");
        }
        if (out.status == 204 || out.status == 304) out.headers.erase("Content-Length");
    }

    HttpShared& shared_;
    Connection& connection_;
    Turn* turn_ = nullptr;
    httplib::Request* library_request_ = nullptr;
};

}  // namespace

void serve_connection(HttpShared& shared, Connection& connection) {
    Session(shared, connection).serve();
}

}  // namespace ossuary::server
