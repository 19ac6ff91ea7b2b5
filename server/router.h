#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/message.h"
#include "server/request_head.h"

namespace ossuary::server {

struct Service;

enum class Body { kNone, kModel };
enum class Audience { kEveryone, kAdministrator };

/// One operation: a method on a pattern, which is a path with at most one `{…}` that stands for one
/// or more characters other than a slash.
struct Route {
    /// Judges the parameters before the body is read.
    using Check = std::optional<Problem> (*)(const Service&, const RequestHead&);
    using Handle = Checked<Response> (*)(Service&, const Request&);

    std::string_view method;
    std::string_view pattern;
    Handle handle = nullptr;
    Check check = nullptr;
    Body body = Body::kNone;
    Audience audience = Audience::kEveryone;
    bool heavy = false;   ///< needs a slot
    bool urgent = false;  ///< see HttpHandler::is_urgent
};

/// Every route but the gallery's files. Of two patterns that fit, the earlier one is meant.
[[nodiscard]] const std::vector<Route>& routes();

struct RouteMatch {
    const Route* route = nullptr;  ///< none where the method or the path is not there
    std::string capture;
    std::string
        allow;  ///< the methods of the path, "GET, HEAD, OPTIONS"; empty without such a path
};

/// HEAD finds the route of GET.
[[nodiscard]] RouteMatch match_route(std::string_view method, std::string_view path);

/// What the pattern's `{…}` stands for in the path; none where the pattern does not fit.
[[nodiscard]] std::optional<std::string> match_pattern(std::string_view pattern,
                                                       std::string_view path);

}  // namespace ossuary::server
