#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/stopwatch.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "engine/voxel/read_model.h"
#include "index/describe_model.h"
#include "index/presentation.h"
#include "index/preview.h"
#include "index/upright.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

struct SearchParameters {
    index::SearchOptions options;
    voxel::InsideOptions inside;
    bool with_mesh = false;
    std::optional<Problem> fault;
};

SearchParameters read_search_parameters(const RequestHead& head) {
    SearchParameters parameters;
    ParameterReader reader(head);
    parameters.options = read_search_options(reader);
    parameters.inside = read_inside(reader);
    parameters.with_mesh = reader.choice("include", {"mesh"}).has_value();
    reader.text("name");
    parameters.fault = reader.finish();
    return parameters;
}

}  // namespace

std::optional<Problem> check_search(const Service&, const RequestHead& head) {
    if (auto fault = read_search_parameters(head).fault) return fault;
    return judge_media_type(head);
}

Checked<Response> search(Service& service, const Request& request) {
    const SearchParameters parameters = read_search_parameters(request.head);
    const auto upload = read_upload(request);
    if (!upload) return tl::unexpected<Problem>(upload.error());
    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());

    Stopwatch watch;
    voxel::ReadModelOptions reading{.inside = parameters.inside};
    reading.mesh.max_bytes = service.options.http.max_body;
    const auto query =
        service.reader.read({upload->bytes, upload->name, {}}, reading, request.stop);
    if (!query) return fail(query.error());
    const double read_ms = watch.lap_ms();
    auto result = service.searcher.search(query->mesh, parameters.options, request.stop);
    if (!result) return fail(result.error());

    result->took_ms += read_ms;
    result->stages_ms.insert(result->stages_ms.begin(), {"read", read_ms});
    // What the file itself is odd about comes before what the stages found.
    result->warnings.insert(result->warnings.begin(), query->warnings.begin(),
                            query->warnings.end());
    service.metrics.search(result->stages_ms);
    index::QueryDescription description{upload->name, query->mesh.vertices.size(),
                                        query->mesh.face_count, index::frame_of(*query)};
    description.up = description.frame.up;
    nlohmann::json preview;
    if (parameters.with_mesh) {
        const mesh::TriangleMesh& body = result->query_body.of(query->mesh);
        const mesh::TriangleMesh coarse = mesh::decimate(body, {}, request.stop);
        if (!description.up) description.up = index::find_up(coarse);
        preview = index::to_json(index::make_preview(coarse), mesh::measure(body).bounds);
    }
    auto json = index::to_json(*result, description, parameters.options.rank);
    if (parameters.with_mesh) json["query"]["mesh"] = std::move(preview);
    Response response = json_answer(json);
    response.set_header("Cache-Control", "no-store");
    return response;
}

}  // namespace ossuary::server
