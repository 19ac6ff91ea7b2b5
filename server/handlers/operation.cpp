#include <nlohmann/json.hpp>

#include "server/embedded.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"

namespace ossuary::server {
namespace {

Response never_cached(Response response) {
    response.set_header("Cache-Control", "no-store");
    return response;
}

}  // namespace

Checked<Response> live(Service&, const Request&) {
    return never_cached(json_answer({{"status", "ok"}}));
}

Checked<Response> ready(Service& service, const Request&) {
    if (service.draining) {
        return fail(RequestFault::kShuttingDown, "The server is shutting down.");
    }
    const auto snapshot = service.searcher.snapshot();
    if (!snapshot) return fail(snapshot.error());
    return never_cached(json_answer({{"status", "ok"}}));
}

Checked<Response> metrics(Service& service, const Request&) {
    if (const auto snapshot = service.searcher.snapshot()) {
        service.metrics.index((*snapshot)->size(), (*snapshot)->revision());
    }
    return never_cached(answer("text/plain; version=0.0.4; charset=utf-8", service.metrics.text()));
}

Checked<Response> describe_interface(Service&, const Request& request) {
    return conditional(request.head, answer("application/yaml", std::string(kOpenApiDocument)));
}

}  // namespace ossuary::server
