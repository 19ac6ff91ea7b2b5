#include "server/cross_origin.h"

#include <algorithm>

namespace ossuary::server {

bool comes_from_allowed(const RequestHead& head, const std::vector<std::string>& allowed) {
    const std::string* origin = find_field(head.headers, "Origin");
    return origin != nullptr && std::ranges::any_of(allowed, [&](const std::string& each) {
               return each == "*" || each == *origin;
           });
}

void add_cross_origin_headers(const RequestHead& head, const std::vector<std::string>& allowed,
                              Response& response) {
    if (allowed.empty()) return;
    // Else a cache may hand one origin the answer to another.
    response.set_header("Vary", "Origin");
    if (!comes_from_allowed(head, allowed)) return;
    response.set_header("Access-Control-Allow-Origin", head.header("Origin"));
    response.set_header("Access-Control-Expose-Headers",
                        "ETag, Location, Retry-After, X-Request-Id");
    const bool asks_first =
        head.method == "OPTIONS" && !head.header("Access-Control-Request-Method").empty();
    if (!asks_first) return;
    const std::string* methods = find_field(response.headers, "Allow");
    if (methods == nullptr) return;
    response.set_header("Access-Control-Allow-Methods", std::string(*methods));
    response.set_header("Access-Control-Allow-Headers",
                        "Authorization, Content-Type, If-None-Match, X-Request-Id");
    response.set_header("Access-Control-Max-Age", "600");
}

}  // namespace ossuary::server
