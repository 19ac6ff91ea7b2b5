#include "server/application.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>

#include "server/auth.h"
#include "server/cross_origin.h"

namespace ossuary::server {
namespace {

using enum RequestFault;

constexpr std::array<std::string_view, 9> kMethods = {
    "GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS", "CONNECT", "TRACE"};

// Scripts, styles, pictures and calls from this server only; meshes' pictures may be data or blobs.
constexpr std::string_view kGalleryPolicy =
    "default-src 'self'; img-src 'self' data: blob:; object-src 'none'; base-uri 'none'; "
    "form-action 'self'; frame-ancestors ";
// Answers are data: should a browser show one as a page, it may do nothing.
constexpr std::string_view kDataPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'none'; sandbox";
/// The one page that is made to be shown within others.
constexpr std::string_view kEmbeddedPage = "/embed.html";

std::string in_one(const std::vector<std::string>& origins) {
    std::string text;
    for (const std::string& each : origins) text += (text.empty() ? "" : " ") + each;
    return text;
}

}  // namespace

bool is_loopback(std::string_view host) {
    if (host == "localhost" || host == "::1" || host == "[::1]") return true;
    // The whole must be an address: 127.0.0.1.example.com is a name that anyone may own.
    in_addr address{};
    return inet_pton(AF_INET, std::string(host).c_str(), &address) == 1 &&
           ntohl(address.s_addr) >> 24 == 127;
}

std::string host_name(std::string_view host) {
    const std::size_t bracket = host.find(']');
    const std::size_t colon = host.find(':', bracket == std::string_view::npos ? 0 : bracket);
    std::string name(host.substr(0, colon));
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return name;
}

void Application::follow_keys() {
    for (Key* key : {&service_.admin_key, &service_.read_key}) {
        const auto other = key->follow();
        if (!other) {
            service_.log.warn(other.error().message + "; the key before it stays in force");
        } else if (*other) {
            service_.log.info("another " + key->name() + " is in force");
        }
    }
}

bool Application::serves_host(const RequestHead& head) const {
    const auto& allowed = service_.options.allowed_hosts;
    const std::string* host = find_field(head.headers, "Host");
    if (host == nullptr) return true;  // HTTP/1.0; browsers always send one
    const std::string name = host_name(*host);
    if (is_loopback(name)) return true;
    if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) return true;
    // On a loopback address any other name means that a page of another site had that name resolved
    // to this machine. On other addresses the administrator may say what the names are.
    return allowed.empty() && !is_loopback(service_.options.host);
}

std::optional<Problem> Application::judge(const RequestHead& head, const Route& route) const {
    if (route.audience == Audience::kAdministrator) {
        if (auto refusal = judge_admin(head, service_.admin_key)) return refusal;
    }
    if (route.method != "GET" && head.header("Sec-Fetch-Site") == "cross-site" &&
        !comes_from_allowed(head, service_.options.allowed_origins)) {
        return problem(kCrossSiteRequest, "Pages of other sites may not send this.");
    }
    if (route.body == Body::kNone) {
        if (head.content_length == 0) return std::nullopt;
        return problem(kBodyUnexpected, "This takes no body.");
    }
    if (find_field(head.headers, "Content-Length") == nullptr) {
        return problem(kLengthRequired, "Send the model with a Content-Length.");
    }
    if (route.check != nullptr) {
        if (auto fault = route.check(service_, head)) return fault;
    }
    if (service_.draining) return problem(kShuttingDown, "The server is shutting down.");
    if (route.heavy && service_.slots.full()) {
        return problem(kOverloaded, "Too many searches are waiting.");
    }
    return std::nullopt;
}

std::optional<Response> Application::admit(const RequestHead& head, const std::string& id) {
    if (!serves_host(head)) {
        Response response = to_response(
            problem(kHostNotServed, "This server does not go by that name."), head.path, id);
        response.close = true;
        return response;
    }
    if (head.path.empty()) {  // the base path itself: the gallery's addresses are below it
        Response response;
        response.status = 308;
        response.set_header("Location", service_.options.http.base_path + "/");
        return response;
    }
    // Whoever asks what may be asked has no key yet; whoever watches the server needs none.
    if (head.method != "OPTIONS" && head.path != "/livez" && head.path != "/readyz") {
        follow_keys();
        if (const auto refusal = judge_reader(head, service_.read_key, service_.admin_key)) {
            return to_response(*refusal, head.path, id);
        }
    }
    const RouteMatch match = match_route(head.method, head.path);
    if (match.route == nullptr) return without_route(head, id, match.allow);
    if (const auto refusal = judge(head, *match.route)) {
        Response response = to_response(*refusal, head.path, id);
        response.route = match.route->pattern;
        return response;
    }
    return std::nullopt;
}

Response Application::without_route(const RequestHead& head, const std::string& id,
                                    const std::string& path_methods) const {
    std::string allow = path_methods;
    if (allow.empty()) {
        if (auto file = service_.files.find(head)) {
            if (head.method == "GET" || head.method == "HEAD") {
                file->route = "gallery";
                if (head.path == kEmbeddedPage)
                    file->framed_by = in_one(service_.options.embedders);
                return *std::move(file);
            }
            allow = "GET, HEAD, OPTIONS";
        }
    }
    const bool known = std::find(kMethods.begin(), kMethods.end(), head.method) != kMethods.end();
    if (!known) return to_response(problem(kMethodUnknown, "No such method."), head.path, id);
    if (head.method == "OPTIONS" && (!allow.empty() || head.path == "*")) {
        Response response;
        response.status = 204;
        response.set_header("Allow",
                            head.path == "*" ? "GET, HEAD, POST, PATCH, DELETE, OPTIONS" : allow);
        return response;
    }
    if (allow.empty()) {
        const bool interface = head.path.starts_with("/v1/");
        return to_response(interface ? problem(kRouteNotFound, "There is nothing at this path.")
                                     : problem(kFileNotServed, "There is no such file here."),
                           head.path, id);
    }
    Problem refusal = problem(kMethodNotAllowed, "This path takes " + allow + ".");
    refusal.headers.push_back({"Allow", allow});
    return to_response(refusal, head.path, id);
}

Response Application::handle(Request& request) {
    RouteMatch match = match_route(request.head.method, request.head.path);
    request.capture = std::move(match.capture);
    auto answered = match.route->handle(service_, request);
    Response response = answered ? *std::move(answered)
                                 : to_response(answered.error(), request.head.path, request.id);
    response.route = match.route->pattern;
    return response;
}

void Application::complete(Response& response, const RequestHead& head, const std::string& id) {
    const bool page = response.content_type.starts_with("text/html");
    response.set_header("X-Request-Id", id);
    response.set_header("X-Content-Type-Options", "nosniff");
    // It knows no origins: where some are named, what the policy says holds alone.
    if (response.framed_by.empty()) response.set_header("X-Frame-Options", "DENY");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cross-Origin-Opener-Policy", "same-origin");
    const auto& origins = service_.options.allowed_origins;
    response.set_header("Cross-Origin-Resource-Policy",
                        comes_from_allowed(head, origins) ? "cross-origin" : "same-origin");
    add_cross_origin_headers(head, origins, response);
    response.set_header("Content-Security-Policy",
                        page ? std::string(kGalleryPolicy) +
                                   (response.framed_by.empty() ? "'none'" : response.framed_by)
                             : std::string(kDataPolicy));
}

void Application::finished(const Exchange& exchange) {
    service_.metrics.request(exchange);
    // Every 500 has its line, also one that nobody gave a reason for.
    if (!exchange.cause.empty() || exchange.status == 500) {
        service_.log.error(exchange.cause.empty() ? "no reason was given" : exchange.cause,
                           exchange.id);
    }
    service_.log.access(exchange);
}

void Application::refused() {
    service_.metrics.connection_refused();
    service_.log.warn("a request was turned away: too many are waiting");
}

bool Application::is_urgent(const RequestHead& head) const {
    const RouteMatch match = match_route(head.method, head.path);
    return match.route != nullptr && match.route->urgent;
}

}  // namespace ossuary::server
