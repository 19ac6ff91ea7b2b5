#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/parallel.h"
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
    std::string progress;  ///< what is told of it goes under this token; empty: nothing
    std::optional<Problem> fault;
};

SearchParameters read_search_parameters(const RequestHead& head) {
    SearchParameters parameters;
    ParameterReader reader(head);
    parameters.options = read_search_options(reader);
    parameters.inside = read_inside(reader);
    parameters.with_mesh = reader.choice("include", {"mesh"}).has_value();
    reader.text("name");
    parameters.progress = reader.text("progress").value_or("");
    if (!parameters.progress.empty() && !is_token(parameters.progress)) {
        reader.refuse("progress", "`progress` is not 32 hexadecimal digits in small letters.");
    }
    parameters.fault = reader.finish();
    return parameters;
}

/// What the page draws of a query.
struct ShownQuery {
    nlohmann::json mesh;
    index::Up up = index::Up::kY;
    double milliseconds = 0.0;
};

Result<ShownQuery> show_query(index::QueryModel& model, const std::stop_token& stop) {
    const Stopwatch watch;
    const auto preview = model.preview(stop);
    if (!preview) return preview.error();
    const auto up = model.up(stop);
    if (!up) return up.error();
    return ShownQuery{index::to_json(*preview, model.bounds()), *up, watch.elapsed_ms()};
}

}  // namespace

std::optional<Problem> check_search(const Service&, const RequestHead& head) {
    if (auto fault = read_search_parameters(head).fault) return fault;
    return judge_media_type(head);
}

Checked<Response> search(Service& service, const Request& request) {
    SearchParameters parameters = read_search_parameters(request.head);
    Progress::Report report(service.progress, parameters.progress);
    const StageReport on_stage = [&report](std::string_view stage) { report.stage(stage); };
    parameters.options.on_stage = on_stage;
    const auto upload = read_upload(request);
    if (!upload) return tl::unexpected<Problem>(upload.error());
    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());

    Stopwatch watch;
    on_stage("read");
    voxel::ReadModelOptions reading{.inside = parameters.inside};
    reading.mesh.max_bytes = service.options.http.max_body;
    auto query = service.reader.read({upload->bytes, upload->name, {}}, reading, request.stop);
    if (!query) return fail(query.error());
    const double read_ms = watch.lap_ms();
    auto described = service.searcher.describe(query->mesh, request.stop, on_stage);
    if (!described) return fail(described.error());
    StageTimes stages = {{"read", read_ms}};
    stages.insert(stages.end(), described->stages_ms.begin(), described->stages_ms.end());
    const double before_ms = read_ms + watch.lap_ms();
    const auto model = std::make_shared<index::QueryModel>(
        upload->name, std::move(query->mesh), std::move(query->warnings), index::frame_of(*query),
        *std::move(described));
    Result<index::SearchResult> result = Error{ErrorCode::kCancelled, "the search was given up"};
    // Which way it stands is told where it is shown.
    std::optional<index::Up> up = model->frame().up;
    Result<ShownQuery> shown = ShownQuery{};
    const auto rank = [&] {
        const bool part = parameters.options.rank.part;
        result = service.searcher.nearest(model->described(), parameters.options, request.stop,
                                          part ? &model->piece() : nullptr);
    };
    const auto show = [&] { shown = show_query(*model, request.stop); };
    parallel_for(parameters.with_mesh ? 2 : 1, 2, [&](std::size_t i) { i == 0 ? rank() : show(); });
    if (!result) return fail(result.error());
    if (!shown) return fail(shown.error());
    if (parameters.with_mesh) {
        stages.push_back({"preview", shown->milliseconds});
        up = shown->up;
    }
    result->stages_ms.insert(result->stages_ms.begin(), stages.begin(), stages.end());
    result->took_ms = before_ms + watch.lap_ms();
    service.metrics.search(result->stages_ms);

    const std::string token = service.queries.keep(model);
    auto json = query_search_json(service, *result, *model, token, up, parameters.options.rank);
    if (parameters.with_mesh) json["query"]["mesh"] = std::move(shown->mesh);
    Response response = json_answer(json);
    response.set_header("Cache-Control", "no-store");
    return response;
}

}  // namespace ossuary::server
