#include "server/http.h"

#include <sys/eventfd.h>

#include <optional>

#include "server/http_library.h"
#include "server/http_loop.h"
#include "server/http_shared.h"

namespace ossuary::server {

struct HttpServer::Impl {
    Impl(const HttpOptions& options, HttpHandler& handler) : shared(options, handler) {}

    HttpShared shared;
    std::optional<HttpLoop> loop;
};

HttpServer::HttpServer(const HttpOptions& options, HttpHandler& handler)
    : impl_(std::make_unique<Impl>(options, handler)) {}

HttpServer::~HttpServer() = default;

Result<int> HttpServer::bind(const std::string& host, int port) {
    const auto listener = listen_on(host, port);
    if (!listener) return listener.error();
    impl_->loop.emplace(impl_->shared, listener->socket);
    return listener->port;
}

Result<void> HttpServer::run() { return impl_->loop->run(); }

void HttpServer::stop() {
    impl_->shared.stopping = true;
    eventfd_write(impl_->shared.wake, 1);
}

void HttpServer::cancel() {
    impl_->shared.watchdog.stop_all();
    impl_->shared.cancelled = true;
    eventfd_write(impl_->shared.wake, 1);
}

}  // namespace ossuary::server
