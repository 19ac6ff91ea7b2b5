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
    int threads = 64;                   ///< requests worked on at once
    std::size_t max_waiting = 128;      ///< requests that may wait for a thread; more get a 503
    std::size_t max_connections = 512;  ///< at once; beyond, those with the least claim give way
    std::size_t max_body = 64 << 20;    ///< bytes of a request's body
    /// Bytes of all bodies that are held at once; a request that does not fit gets a 503.
    std::size_t max_bodies = 256 << 20;
    HeadLimits head;
    std::string base_path;  ///< taken off the paths that begin with it; what is left may be empty
    std::chrono::milliseconds head_timeout{10'000};  ///< for the header to arrive
    /// For the body to arrive, then for the answer to be made, then for it to be taken.
    std::chrono::milliseconds request_timeout{60'000};
    std::chrono::milliseconds keep_alive_timeout{15'000};  ///< between requests
    std::size_t max_requests = 1000;                       ///< on one connection
    /// How long what a client still sends is swallowed after the last answer, so that it can read
    /// that answer.
    std::chrono::milliseconds linger{2'000};
    /// A body or an answer of which nothing has gone through for this long, or less than
    /// `slow_bytes_per_second` since its beginning, has little claim to its connection.
    std::chrono::milliseconds slow_after{2'000};
    double slow_bytes_per_second = 1024.0;
};

/// What the log and the metrics hear of one request.
struct Exchange {
    std::string id;
    std::string method;
    std::string target;  ///< path, or the raw line of a request that could not be parsed
    std::string remote_address;
    int status = 0;
    std::string code;   ///< of the problem, if any
    std::string cause;  ///< what went wrong on our side; for the log only
    std::string route;  ///< as the handler named it
    std::size_t bytes_in = 0;
    std::size_t bytes_out = 0;
    double milliseconds = 0.0;  ///< first byte in to last byte out
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
    /// Adds what every answer carries, also those to requests that were never admitted, whose head
    /// may be empty.
    virtual void complete(Response& response, const RequestHead& head, const std::string& id) = 0;
    virtual void finished(const Exchange& exchange) = 0;
    /// Somebody was turned away because too many were waiting.
    virtual void refused() = 0;
    /// Whether a request is answered at once from what is in memory and must be, whatever else goes
    /// on: it does not wait behind others for a thread.
    [[nodiscard]] virtual bool is_urgent(const RequestHead& /*head*/) const { return false; }
};

/// Speaks HTTP/1.1 over TCP. One thread accepts, receives, sends and keeps the deadlines of all
/// connections; the workers get requests that have arrived whole. So a client that is silent, slow
/// or does not read holds a connection and no thread. Headers are read and judged by `check_head`
/// alone. When there are too many connections, those with the least claim give way: that have not
/// sent a byte, that idle between requests, whose header is slow, then whose body or answer is.
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
    /// Asks the requests under way to end early, and gives up those that are still arriving or
    /// leaving.
    void cancel();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ossuary::server
