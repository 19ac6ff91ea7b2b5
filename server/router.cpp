#include "server/router.h"

namespace ossuary::server {

std::optional<std::string> match_pattern(std::string_view pattern, std::string_view path) {
    const std::size_t open = pattern.find('{');
    if (open == std::string_view::npos) {
        return pattern == path ? std::optional<std::string>("") : std::nullopt;
    }
    const std::string_view prefix = pattern.substr(0, open);
    const std::string_view suffix = pattern.substr(pattern.find('}') + 1);
    if (path.size() <= prefix.size() + suffix.size() || !path.starts_with(prefix) ||
        !path.ends_with(suffix)) {
        return std::nullopt;
    }
    const std::string_view middle =
        path.substr(prefix.size(), path.size() - prefix.size() - suffix.size());
    if (middle.find('/') != std::string_view::npos) return std::nullopt;
    return std::string(middle);
}

RouteMatch match_route(std::string_view method, std::string_view path) {
    const std::string_view wanted = method == "HEAD" ? "GET" : method;
    RouteMatch match;
    std::string_view pattern;
    for (const Route& route : routes()) {
        // The first pattern that fits is the resource; its other methods have the same pattern.
        if (!pattern.empty() && route.pattern != pattern) continue;
        auto capture = match_pattern(route.pattern, path);
        if (!capture) continue;
        pattern = route.pattern;
        match.allow += std::string(route.method) + (route.method == "GET" ? ", HEAD, " : ", ");
        if (route.method != wanted) continue;
        match.route = &route;
        match.capture = *std::move(capture);
    }
    if (!match.allow.empty()) match.allow += "OPTIONS";
    return match;
}

}  // namespace ossuary::server
