#include "server/http.h"

#include <httplib.h>
#include <sys/eventfd.h>

#include <condition_variable>
#include <cstring>
#include <mutex>
#include <thread>
#include <utility>

#include "server/connection.h"
#include "server/http_session.h"
#include "server/http_shared.h"
#include "server/http_workers.h"

namespace ossuary::server {
namespace {

using enum RequestFault;

/// Listens and accepts; each connection is served on one of the workers.
class Acceptor : public httplib::Server {
public:
    explicit Acceptor(HttpShared& shared) : shared_(shared) {
        new_task_queue = [this] {
            accepting_thread_ = std::this_thread::get_id();
            return new HttpWorkers(shared_.options.threads, shared_.options.max_waiting,
                                   shared_.waiting);
        };
        // The library's default adds SO_REUSEPORT, with which a second server on the same port
        // would start without a word and take half of the connections.
        set_socket_options([](socket_t socket) {
            const int on = 1;
            setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        });
    }

    int bind(const std::string& host, int port) {
        const int bound =
            port == 0 ? bind_to_any_port(host) : (bind_to_port(host, port) ? port : -1);
        // The library asks for a backlog of 5, which a browser alone can fill.
        if (bound > 0) ::listen(svr_sock_, 512);
        return bound;
    }
    [[nodiscard]] bool accepting() const { return svr_sock_ != INVALID_SOCKET; }

private:
    bool process_and_close_socket(socket_t socket) override {
        Connection connection(socket);
        if (std::this_thread::get_id() == accepting_thread_) {
            turn_away(connection);
            return false;
        }
        serve_connection(shared_, connection);
        return true;
    }

    /// On the accepting thread, so without waiting for anything.
    void turn_away(Connection& connection) {
        shared_.handler.refused();  // before the answer: who has that finds it counted
        const std::string id = shared_.new_id();
        Response response =
            to_response(problem(kOverloaded, "Too many connections are waiting."), "", id);
        shared_.handler.complete(response, id);
        std::string text = "HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\n";
        for (const Field& field : response.headers)
            text += field.name + ": " + field.value + "\r\n";
        text += "Content-Type: " + response.content_type +
                "\r\nContent-Length: " + std::to_string(response.body.size()) + "\r\n\r\n";
        text += response.body;
        connection.set_write_deadline(Clock::now());
        connection.write(text.data(), text.size());
        connection.linger(std::chrono::milliseconds(0));
    }

    HttpShared& shared_;
    std::thread::id accepting_thread_;
};

}  // namespace

struct HttpServer::Impl {
    Impl(const HttpOptions& options, HttpHandler& handler)
        : shared(options, handler), acceptor(shared) {}

    HttpShared shared;
    Acceptor acceptor;
    std::string host;
    int port = 0;
    std::mutex mutex;
    std::condition_variable changed;
    bool running = false;
};

HttpServer::HttpServer(const HttpOptions& options, HttpHandler& handler)
    : impl_(std::make_unique<Impl>(options, handler)) {}

HttpServer::~HttpServer() = default;

Result<int> HttpServer::bind(const std::string& host, int port) {
    impl_->host = host;
    impl_->port = impl_->acceptor.bind(host, port);
    if (impl_->port > 0) return impl_->port;
    return {ErrorCode::kInvalidArgument,
            "cannot listen on " + host + ":" + std::to_string(port) + ": " + std::strerror(errno)};
}

Result<void> HttpServer::run() {
    {
        std::lock_guard lock(impl_->mutex);
        if (impl_->shared.stopping) return {};
        impl_->running = true;
    }
    // The library gives up when accept fails, be it for one connection that was reset in between.
    bool sound = true;
    while (sound && !impl_->shared.stopping) {
        impl_->acceptor.listen_after_bind();
        if (!impl_->shared.stopping) sound = impl_->acceptor.bind(impl_->host, impl_->port) > 0;
    }
    {
        std::lock_guard lock(impl_->mutex);
        impl_->running = false;
    }
    impl_->changed.notify_all();
    if (!sound) return {ErrorCode::kInternal, "the listening socket failed"};
    return {};
}

void HttpServer::stop() {
    std::unique_lock lock(impl_->mutex);
    impl_->shared.stopping = true;
    eventfd_write(impl_->shared.wake, 1);
    // `listen_after_bind` can be stopped only once it has come to its loop.
    while (impl_->running && impl_->acceptor.accepting()) {
        if (impl_->acceptor.is_running()) impl_->acceptor.stop();
        impl_->changed.wait_for(lock, std::chrono::milliseconds(5));
    }
}

void HttpServer::cancel() { impl_->shared.watchdog.stop_all(); }

}  // namespace ossuary::server
