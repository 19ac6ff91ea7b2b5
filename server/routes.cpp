#include "server/handlers/handlers.h"
#include "server/router.h"

namespace ossuary::server {

const std::vector<Route>& routes() {
    using enum Audience;
    static const std::vector<Route> table = {
        {"POST", "/v1/search", search, check_search, Body::kModel, kEveryone, true},
        {"GET", "/v1/models", list_models},
        {"GET", "/v1/facets", list_facets},
        {"POST", "/v1/models", add_model, check_add_model, Body::kModel, kAdministrator},
        {"GET", "/v1/models/{id}", get_model},
        {"PATCH", "/v1/models/{id}", change_model, nullptr, Body::kNone, kAdministrator},
        {"DELETE", "/v1/models/{id}", remove_model, nullptr, Body::kNone, kAdministrator},
        {"GET", "/v1/models/{id}/similar", similar, nullptr, Body::kNone, kEveryone, true},
        {"GET", "/v1/models/{id}/mesh", model_mesh},
        {"GET", "/v1/models/{id}/skeleton", model_skeleton},
        {"GET", "/v1/models/{id}/segments", model_segments},
        {"GET", "/v1/models/{id}/rig.glb", model_rig},
        {"GET", "/v1/models/{id}/thumbnail.png", model_thumbnail},
        {"GET", "/v1/models/{id}/file", model_file, nullptr, Body::kNone, kEveryone, true},
        {"GET", "/v1/models/{id}/mesh.stl", model_stl, nullptr, Body::kNone, kEveryone, true},
        {"GET", "/v1/queries/{token}", get_query},
        {"GET", "/v1/queries/{token}/similar", query_similar, nullptr, Body::kNone, kEveryone,
         true},
        {"GET", "/v1/queries/{token}/mesh", query_mesh},
        {"GET", "/v1/queries/{token}/skeleton", query_skeleton},
        {"GET", "/v1/queries/{token}/segments", query_segments, nullptr, Body::kNone, kEveryone,
         true},
        {"GET", "/v1/queries/{token}/rig.glb", query_rig, nullptr, Body::kNone, kEveryone, true},
        {"GET", "/v1/queries/{token}/mesh.stl", query_stl},
        {"GET", "/v1/compare", compare, nullptr, Body::kNone, kEveryone, true},
        {"GET", "/v1/evaluations", list_evaluations},
        // Before the pattern that would take the ending for a part of the ranker's name.
        {"GET", "/v1/evaluations/{ranker}.csv", evaluation_csv},
        {"GET", "/v1/evaluations/{ranker}.svg", evaluation_svg},
        {"GET", "/v1/evaluations/{ranker}", evaluation_json},
        // However many searches run.
        {"GET", "/v1/progress/{token}", get_progress, nullptr, Body::kNone, kEveryone, false, true},
        {"GET", "/v1/jobs", list_jobs, nullptr, Body::kNone, kAdministrator},
        {"GET", "/v1/jobs/{id}", get_job},
        {"GET", "/v1/failures", list_failures, nullptr, Body::kNone, kAdministrator},
        {"GET", "/livez", live, nullptr, Body::kNone, kEveryone, false, true},
        {"GET", "/readyz", ready},
        {"GET", "/metrics", metrics},
        {"GET", "/openapi.yaml", describe_interface},
    };
    return table;
}

}  // namespace ossuary::server
