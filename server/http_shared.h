#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "server/http.h"
#include "server/watchdog.h"

namespace ossuary::server {

/// What the connections of one server share.
struct HttpShared {
    HttpOptions options;
    HttpHandler& handler;
    Watchdog watchdog;
    std::atomic<bool> stopping = false;
    std::atomic<bool> cancelled = false;
    std::atomic<std::size_t> connections = 0;
    std::atomic<std::size_t> body_bytes = 0;
    std::atomic<std::uint64_t> next_id = 0;
    std::string id_prefix;
    int wake = -1;  ///< an eventfd; written whenever the loop has something to look at

    HttpShared(const HttpOptions& chosen, HttpHandler& handler_)
        : options(chosen), handler(handler_) {
        std::random_device random;
        constexpr std::string_view kDigits = "0123456789abcdef";
        for (int i = 0; i < 8; ++i) id_prefix.push_back(kDigits[random() % 16]);
        wake = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    }
    ~HttpShared() { ::close(wake); }
    HttpShared(const HttpShared&) = delete;
    HttpShared& operator=(const HttpShared&) = delete;

    std::string new_id() { return id_prefix + "-" + std::to_string(++next_id); }

    /// Whether connections should end after their answer rather than idle: the server stops, or so
    /// many are open that some will have to give way soon.
    [[nodiscard]] bool ends_connections() const {
        return stopping || 4 * connections > 3 * options.max_connections;
    }
};

}  // namespace ossuary::server
