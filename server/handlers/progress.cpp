#include <nlohmann/json.hpp>

#include "server/handlers/handlers.h"

namespace ossuary::server {

Checked<Response> get_progress(Service& service, const Request& request) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    // Asked before and after the search runs, too: that is no fault of the client's.
    const auto stage = service.progress.find(request.capture);
    Response response = json_answer({{"stage", stage ? nlohmann::json(*stage) : nlohmann::json()}});
    response.set_header("Cache-Control", "no-store");
    return response;
}

}  // namespace ossuary::server
