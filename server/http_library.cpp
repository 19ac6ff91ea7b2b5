#include "server/http_library.h"

#include <httplib.h>

#include <cerrno>
#include <cstring>

namespace ossuary::server {

// What is used here is as this version has it: the options are set on each socket that is tried,
// the server leaves a socket open that it has bound, and the compressor is not part of what the
// library promises.
static_assert(std::string_view(CPPHTTPLIB_VERSION) == "0.11.4",
              "another version of cpp-httplib: read http_library.cpp against it");

Result<Listener> listen_on(const std::string& host, int port) {
    Listener listener;
    httplib::Server binder;
    // SO_REUSEADDR alone: the library's own choice adds SO_REUSEPORT, with which a second server on
    // the same port would start without a word and take half of the connections.
    binder.set_socket_options([&listener](socket_t socket) {
        const int on = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        listener.socket = socket;
    });
    errno = 0;
    if (port == 0) {
        listener.port = binder.bind_to_any_port(host);
    } else {
        listener.port = binder.bind_to_port(host, port) ? port : -1;
    }
    if (listener.port <= 0) {
        return {ErrorCode::kInvalidArgument,
                "cannot listen on " + host + ":" + std::to_string(port) + ": " +
                    (errno != 0 ? std::strerror(errno) : "no address")};
    }
    // The library asks for a backlog of 5, which a browser alone can fill.
    ::listen(listener.socket, 512);
    return listener;
}

std::optional<std::string> gzip(std::string_view bytes) {
    httplib::detail::gzip_compressor compressor;
    std::string packed;
    const bool complete = compressor.compress(bytes.data(), bytes.size(), true,
                                              [&packed](const char* data, std::size_t size) {
                                                  packed.append(data, size);
                                                  return true;
                                              });
    if (!complete) return std::nullopt;
    return packed;
}

}  // namespace ossuary::server
