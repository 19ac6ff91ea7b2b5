#include <nlohmann/json.hpp>
#include <span>

#include "index/presentation.h"
#include "index/report.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

/// The evaluation that path and parameters name.
Checked<Evaluations::Shared> asked_evaluation(Service& service, const Request& request,
                                              ParameterReader& reader) {
    ranking::RankOptions options;
    options.jobs = 0;
    options.rerank = reader.boolean("rerank").value_or(false);
    const auto ranker = ranking::parse_ranker(request.capture);
    if (!ranker) reader.refuse("ranker", ranker.error().message);
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    options.ranker = *ranker;
    const auto snapshot = service.searcher.snapshot();
    if (!snapshot) return fail(snapshot.error());
    const auto evaluation = service.evaluations.get(*snapshot, options, request.stop);
    if (!evaluation) return fail(RequestFault::kOverloaded, "Too many evaluations are waited for.");
    if (!*evaluation) return fail(evaluation->error());
    return **evaluation;
}

nlohmann::json entry(const Service& service, ranking::RankerKind ranker, bool rerank,
                     const Evaluable& collection, nlohmann::json computed_at) {
    const std::string base =
        service.options.http.base_path + "/v1/evaluations/" + std::string(to_string(ranker));
    const std::string query = rerank ? "?rerank=true" : "";
    return {
        {"ranker", to_string(ranker)},
        {"rerank", rerank},
        {"models", collection.models},
        {"classes", collection.classes},
        {"computed_at", std::move(computed_at)},
        {"links",
         {{"json", base + query}, {"csv", base + ".csv" + query}, {"svg", base + ".svg" + query}}}};
}

}  // namespace

Checked<Response> list_evaluations(Service& service, const Request& request) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    const auto snapshot = service.searcher.snapshot();
    if (!snapshot) return fail(snapshot.error());
    const auto stored = service.searcher.store().evaluations();
    if (!stored) return fail(stored.error());

    auto list = nlohmann::json::array();
    const Evaluable collection = evaluable(**snapshot);
    const bool possible = collection.classes >= 2;
    const std::size_t asked = service.evaluations.sample_of(collection.models);
    for (const ranking::RankerKind ranker : ranking::kAllRankers) {
        for (const bool rerank : {false, true}) {
            ranking::RankOptions options;
            options.ranker = ranker;
            options.rerank = rerank;
            std::string computed_at;
            if (const auto known = service.evaluations.peek(**snapshot, options)) {
                computed_at = (*known)->computed_at;
            }
            for (const index::StoredEvaluation& each : *stored) {
                if (each.key.ranker == ranker && each.key.rerank == rerank &&
                    each.key.pose == options.pose && each.report.models == asked) {
                    computed_at = each.computed_at;
                }
            }
            if (!computed_at.empty()) {
                list.push_back(entry(service, ranker, rerank, collection, computed_at));
            } else if (possible && !rerank) {
                list.push_back(entry(service, ranker, rerank, collection, nullptr));
            }
        }
    }
    return conditional(request.head, json_answer({{"evaluations", std::move(list)}}));
}

Checked<Response> evaluation_json(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const bool with_queries = reader.choice("include", {"queries"}).has_value();
    const auto asked = asked_evaluation(service, request, reader);
    if (!asked) return tl::unexpected<Problem>(asked.error());
    auto json = index::to_json(**asked);
    if (with_queries) {
        const auto snapshot = service.searcher.snapshot();
        if (!snapshot) return fail(snapshot.error());
        const auto catalogue = (*snapshot)->catalogue(service.searcher.store());
        if (!catalogue) return fail(catalogue.error());
        json["queries"] = index::queries_json(**asked, **snapshot, **catalogue);
    }
    return conditional(request.head, json_answer(json));
}

Checked<Response> evaluation_csv(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const auto asked = asked_evaluation(service, request, reader);
    if (!asked) return tl::unexpected<Problem>(asked.error());
    const std::span<const index::Evaluation> one(asked->get(), 1);
    Response response = answer("text/csv; charset=utf-8", index::precision_recall_csv(one));
    response.set_header("Content-Disposition",
                        "inline; filename=\"precision-recall-" + request.capture + ".csv\"");
    return conditional(request.head, std::move(response));
}

Checked<Response> evaluation_svg(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const auto asked = asked_evaluation(service, request, reader);
    if (!asked) return tl::unexpected<Problem>(asked.error());
    const std::span<const index::Evaluation> one(asked->get(), 1);
    return conditional(request.head, answer("image/svg+xml", index::precision_recall_svg(one)));
}

}  // namespace ossuary::server
