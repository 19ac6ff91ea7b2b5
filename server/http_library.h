#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace ossuary::server {

// What the server uses of cpp-httplib, and the only file that knows it: names are resolved and
// bound, and answers compressed. Requests are read and judged, and answers written, by our own code
// (request_head.h, http_session.h), so that every limit of ours holds for every request.

struct Listener {
    int socket = -1;  ///< listening; the caller's to close
    int port = 0;
};

/// Listens on an address of this machine, on a free port for 0.
/// Errors: invalid_argument when the address cannot be bound.
Result<Listener> listen_on(const std::string& host, int port);

/// The bytes as `Content-Encoding: gzip` has them; none where they cannot be compressed.
[[nodiscard]] std::optional<std::string> gzip(std::string_view bytes);

}  // namespace ossuary::server
