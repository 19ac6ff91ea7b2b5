#include <limits>
#include <nlohmann/json.hpp>

#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {

Checked<Response> compare(Service& service, const Request& request) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    ParameterReader reader(request.head);
    reader.require("a");
    reader.require("b");
    const auto a = reader.integer("a", 1, kMost);
    const auto b = reader.integer("b", 1, kMost);
    const ranking::RankOptions options = read_rank_options(reader, false);
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));

    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    const auto comparison = service.searcher.compare(*a, *b, options, request.stop);
    if (!comparison) return fail(comparison.error());
    auto json = index::to_json(*comparison, options);
    const index::ModelRoots roots = roots_of(service);
    json["a"] = model_json(service, roots, comparison->a.summary);
    json["b"] = model_json(service, roots, comparison->b.summary);
    return conditional(request.head, json_answer(json));
}

}  // namespace ossuary::server
