#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/stopwatch.h"
#include "engine/voxel/read_model.h"
#include "index/describe_model.h"
#include "index/presentation.h"
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
    auto query = service.reader.read({upload->bytes, upload->name, {}}, reading, request.stop);
    if (!query) return fail(query.error());
    const double read_ms = watch.lap_ms();
    auto described = service.searcher.describe(query->mesh, request.stop);
    if (!described) return fail(described.error());
    auto result = service.searcher.nearest(*described, parameters.options, request.stop);
    if (!result) return fail(result.error());
    StageTimes stages = {{"read", read_ms}};
    stages.insert(stages.end(), described->stages_ms.begin(), described->stages_ms.end());
    result->stages_ms.insert(result->stages_ms.begin(), stages.begin(), stages.end());
    result->took_ms = read_ms + watch.lap_ms();
    service.metrics.search(result->stages_ms);

    const auto model = std::make_shared<index::QueryModel>(
        upload->name, std::move(query->mesh), std::move(query->warnings), index::frame_of(*query),
        *std::move(described));
    const std::string token = service.queries.keep(model);
    // Which way it stands is told where it is shown.
    std::optional<index::Up> up = model->frame().up;
    nlohmann::json mesh;
    if (parameters.with_mesh) {
        const auto preview = model->preview(request.stop);
        if (!preview) return fail(preview.error());
        mesh = index::to_json(*preview, model->bounds());
        const auto found = model->up(request.stop);
        if (!found) return fail(found.error());
        up = *found;
    }
    auto json = query_search_json(service, *result, *model, token, up, parameters.options.rank);
    if (parameters.with_mesh) json["query"]["mesh"] = std::move(mesh);
    Response response = json_answer(json);
    response.set_header("Cache-Control", "no-store");
    return response;
}

}  // namespace ossuary::server
