#pragma once

#include <string>
#include <vector>

#include "server/message.h"

// What pages of other origins may do: the CORS protocol of the Fetch standard, for origins that the
// administrator has named.

namespace ossuary::server {

/// Whether a request comes from a page of an origin that may read answers.
/// @param allowed  origins as browsers name them; `*` for all
[[nodiscard]] bool comes_from_allowed(const RequestHead& head,
                                      const std::vector<std::string>& allowed);

/// Adds to any answer what tells the browser so; nothing where no origin is allowed.
void add_cross_origin_headers(const RequestHead& head, const std::vector<std::string>& allowed,
                              Response& response);

}  // namespace ossuary::server
