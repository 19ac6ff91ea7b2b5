// Uploads that were searched with, and are kept for a while.

#include <nlohmann/json.hpp>

#include "engine/mesh/write_mesh.h"
#include "index/model_segments.h"
#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

using Kept = std::shared_ptr<index::QueryModel>;

Checked<Kept> kept_query(Service& service, const Request& request) {
    auto query = service.queries.find(request.capture);
    if (query) return query;
    return fail(RequestFault::kQueryNotFound,
                "An upload is kept for a quarter of an hour after it was last asked for; this one "
                "is gone. Send it again.");
}

/// The query of a request that takes no parameters.
Checked<Kept> only_query(Service& service, const Request& request) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    return kept_query(service, request);
}

nlohmann::json links(const Service& service, const std::string& token) {
    const std::string base = service.options.http.base_path + "/v1/queries/" + token;
    return {{"similar", base + "/similar"},   {"mesh", base + "/mesh"},
            {"skeleton", base + "/skeleton"}, {"segments", base + "/segments"},
            {"rig", base + "/rig.glb"},       {"stl", base + "/mesh.stl"}};
}

}  // namespace

nlohmann::json query_search_json(Service& service, const index::SearchResult& result,
                                 const index::QueryModel& query, const std::string& token,
                                 std::optional<index::Up> up, const ranking::RankOptions& options) {
    const mesh::TriangleMesh& mesh = query.mesh();
    index::QueryDescription description{query.name(), mesh.vertices.size(), mesh.face_count,
                                        query.frame()};
    description.up = up;
    nlohmann::json json = search_json(service, result, description, options);
    json["query"]["warnings"] = index::to_json(query.warnings());
    json["query"]["skeleton"] = index::to_json(query.described().skeleton);
    json["token"] = token.empty() ? nlohmann::json() : nlohmann::json(token);
    return json;
}

Checked<Response> get_query(Service& service, const Request& request) {
    const auto query = only_query(service, request);
    if (!query) return tl::unexpected<Problem>(query.error());
    const mesh::TriangleMesh& mesh = (*query)->mesh();
    return conditional(request.head,
                       json_answer({{"token", request.capture},
                                    {"name", (*query)->name()},
                                    {"vertices", mesh.vertices.size()},
                                    {"faces", mesh.face_count},
                                    {"bounds", index::to_json((*query)->bounds())},
                                    {"warnings", index::to_json((*query)->warnings())},
                                    {"links", links(service, request.capture)}}));
}

Checked<Response> query_similar(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const index::SearchOptions options = read_search_options(reader);
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    const auto query = kept_query(service, request);
    if (!query) return tl::unexpected<Problem>(query.error());
    const auto snapshot = service.searcher.snapshot();
    if (!snapshot) return fail(snapshot.error());
    std::string etag = ranking_tag(service, **snapshot, request.head);
    if (is_current(request.head, etag)) return not_modified(std::move(etag));

    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    const auto result = service.searcher.nearest((*query)->described(), options, request.stop,
                                                 options.rank.part ? &(*query)->piece() : nullptr);
    if (!result) return fail(result.error());
    service.metrics.search(result->stages_ms);
    const auto up = (*query)->up(request.stop);
    if (!up) return fail(up.error());
    return conditional(request.head,
                       json_answer(query_search_json(service, *result, **query, request.capture,
                                                     *up, options.rank)),
                       std::move(etag));
}

Checked<Response> query_mesh(Service& service, const Request& request) {
    const auto query = only_query(service, request);
    if (!query) return tl::unexpected<Problem>(query.error());
    const auto mesh = (*query)->preview(request.stop);
    if (!mesh) return fail(mesh.error());
    return conditional(request.head, json_answer(index::to_json(*mesh, (*query)->bounds())));
}

Checked<Response> query_skeleton(Service& service, const Request& request) {
    const auto query = only_query(service, request);
    if (!query) return tl::unexpected<Problem>(query.error());
    return conditional(request.head, json_answer(index::to_json((*query)->described().skeleton)));
}

Checked<Response> query_segments(Service& service, const Request& request) {
    const auto query = only_query(service, request);
    if (!query) return tl::unexpected<Problem>(query.error());
    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    const auto segments = (*query)->segments(request.stop);
    if (!segments) return fail(segments.error());
    return conditional(request.head, json_answer(index::to_json(*segments)));
}

Checked<Response> query_rig(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const bool full = reader.choice("detail", {"full"}).has_value();
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    const auto query = kept_query(service, request);
    if (!query) return tl::unexpected<Problem>(query.error());
    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    if (full) return full_rig((*query)->mesh(), (*query)->name(), request);
    const auto segments = (*query)->segments(request.stop);
    if (!segments) return fail(segments.error());
    const auto mesh = (*query)->preview(request.stop);
    if (!mesh) return fail(mesh.error());
    return rig_answer(request, *mesh, *segments, (*query)->described().skeleton.graph,
                      (*query)->name());
}

Checked<Response> query_stl(Service& service, const Request& request) {
    const auto query = only_query(service, request);
    if (!query) return tl::unexpected<Problem>(query.error());
    return as_download(
        conditional(request.head, answer("model/stl", mesh::to_stl((*query)->mesh()))),
        (*query)->name() + ".stl");
}

}  // namespace ossuary::server
