#pragma once

#include <cstddef>
#include <string_view>
#include <tl/expected.hpp>

#include "server/message.h"
#include "server/problem.h"

namespace ossuary::server {

/// A value, or the problem that the client is told of.
template <typename T>
using Checked = tl::expected<T, Problem>;

struct HeadLimits {
    std::size_t max_bytes = 32 << 10;  ///< request line and header fields together
    std::size_t max_target = 4096;     ///< bytes of path and query
    std::size_t max_fields = 100;
};

/// Parses and judges a request's line and header, before anything else sees them. Refused, rather
/// than repaired, is whatever two parsers might read differently or a later stage might trip over:
/// bare CR or LF, folded lines, white space around names, control bytes (also percent-encoded in
/// the path or a parameter), `Transfer-Encoding` (411), `Content-Encoding` (415), lengths that are
/// repeated or contradicted (400), too many or too large fields (431), a long target (414).
/// @param raw  the bytes up to and including the empty line
Checked<RequestHead> check_head(std::string_view raw, const HeadLimits& limits = {});

/// The path and method of a head that `check_head` refused, as far as they can be told, for logs:
/// printable ASCII only.
[[nodiscard]] std::string loggable_target(std::string_view raw);

/// Decodes %XX, and `+` as a space where `plus_is_space`. Refuses malformed escapes, control
/// characters and what is not UTF-8.
Checked<std::string> percent_decode(std::string_view text, bool plus_is_space);

/// Whether the bytes are well-formed UTF-8 (no overlong forms, no surrogates).
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace ossuary::server
