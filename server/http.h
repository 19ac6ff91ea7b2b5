#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "server/message.h"
#include "server/request_head.h"

namespace ossuary::server {

struct HttpOptions {
    int threads = 64;                 ///< connections served at once; idle ones make room
    std::size_t max_waiting = 128;    ///< connections that may wait for a thread; more get a 503
    std::size_t max_body = 64 << 20;  ///< bytes of a request's body
    /// Bytes of all bodies that are held at once; a request that does not fit gets a 503.
    std::size_t max_bodies = 256 << 20;
    HeadLimits head;
    std::chrono::milliseconds head_timeout{10'000};  ///< for the header to arrive
    /// For the body to arrive, then for the answer to be made, then for it to be taken.
    std::chrono::milliseconds request_timeout{60'000};
    std::chrono::milliseconds keep_alive_timeout{15'000};  ///< between requests
    std::size_t max_requests = 1000;                       ///< on one connection
    std::chrono::milliseconds linger{2'000};               ///< how long a refused body is swallowed
};

/// What the log and the metrics hear of one request.
struct Exchange {
    std::string id;
    std::string method;
    std::string target;  ///< path, or the raw line of a request that could not be parsed
    std::string remote_address;
    int status = 0;
    std::string code;   ///< of the problem, if any
    std::string route;  ///< as the handler named it
    std::size_t bytes_in = 0;
    std::size_t bytes_out = 0;
    double milliseconds = 0.0;
};

/// What an HTTP server does with requests. Called from many threads at once. No exception may leave
/// it; should one, the answer is a plain 500.
class HttpHandler {
public:
    virtual ~HttpHandler() = default;
    /// Judges a request before its body is read. An answer given here is final: the body is not
    /// read.
    virtual std::optional<Response> admit(const RequestHead& head, const std::string& id) = 0;
    virtual Response handle(Request& request) = 0;
    /// Adds what every answer carries, also those to requests that were never admitted.
    virtual void complete(Response& response, const std::string& id) = 0;
    virtual void finished(const Exchange& exchange) = 0;
    /// A connection was turned away because too many were waiting.
    virtual void refused() = 0;
};

/// Speaks HTTP/1.1 over TCP. The only thing in the program that knows cpp-httplib, which is lent a
/// part only: it accepts, reads bodies of a known length and writes answers. Headers are read and
/// judged here (`check_head`) before it sees them, and it is handed a request line and header of
/// our own writing, because in version 0.11.4 chunked bodies and compressed ones pass the payload
/// limit, a REMOTE_ADDR header shadows the socket's address, contradicting lengths and 100,000
/// fields are taken, and paths meet a recursive regular expression.
class HttpServer {
public:
    HttpServer(const HttpOptions& options, HttpHandler& handler);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// Binds; the port, which was chosen freely for 0. Errors: invalid_argument when the address
    /// cannot be bound.
    Result<int> bind(const std::string& host, int port);
    /// Serves until `stop`, then finishes what is under way. Errors: internal when the socket
    /// fails.
    Result<void> run();
    /// Takes no new requests; `run` returns when those under way are answered. From any thread,
    /// also before `run`.
    void stop();
    /// Asks the requests under way to end early.
    void cancel();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ossuary::server
