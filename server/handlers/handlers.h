#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "index/presentation.h"
#include "index/query_model.h"
#include "server/message.h"
#include "server/request_head.h"
#include "server/service.h"

namespace ossuary::server {

// Each handler parses a request and answers it; what it takes lives in the index. One group of
// routes a file; `check_…` judges parameters before a body is read.

std::optional<Problem> check_search(const Service& service, const RequestHead& head);
Checked<Response> search(Service& service, const Request& request);
Checked<Response> similar(Service& service, const Request& request);
Checked<Response> compare(Service& service, const Request& request);

Checked<Response> list_models(Service& service, const Request& request);
Checked<Response> list_facets(Service& service, const Request& request);
Checked<Response> get_model(Service& service, const Request& request);
Checked<Response> model_mesh(Service& service, const Request& request);
Checked<Response> model_skeleton(Service& service, const Request& request);
Checked<Response> model_segments(Service& service, const Request& request);
Checked<Response> model_rig(Service& service, const Request& request);
Checked<Response> model_thumbnail(Service& service, const Request& request);
Checked<Response> model_file(Service& service, const Request& request);
Checked<Response> model_stl(Service& service, const Request& request);

Checked<Response> get_progress(Service& service, const Request& request);

Checked<Response> get_query(Service& service, const Request& request);
Checked<Response> query_similar(Service& service, const Request& request);
Checked<Response> query_mesh(Service& service, const Request& request);
Checked<Response> query_skeleton(Service& service, const Request& request);
Checked<Response> query_segments(Service& service, const Request& request);
Checked<Response> query_rig(Service& service, const Request& request);
Checked<Response> query_stl(Service& service, const Request& request);

Checked<Response> list_evaluations(Service& service, const Request& request);
Checked<Response> evaluation_json(Service& service, const Request& request);
Checked<Response> evaluation_csv(Service& service, const Request& request);
Checked<Response> evaluation_svg(Service& service, const Request& request);

std::optional<Problem> check_add_model(const Service& service, const RequestHead& head);
Checked<Response> add_model(Service& service, const Request& request);
Checked<Response> change_model(Service& service, const Request& request);
Checked<Response> remove_model(Service& service, const Request& request);
Checked<Response> list_failures(Service& service, const Request& request);
Checked<Response> list_jobs(Service& service, const Request& request);
Checked<Response> get_job(Service& service, const Request& request);

Checked<Response> live(Service& service, const Request& request);
Checked<Response> ready(Service& service, const Request& request);
Checked<Response> metrics(Service& service, const Request& request);
Checked<Response> describe_interface(Service& service, const Request& request);

// What several of them need.

/// `error` on its way to the client.
[[nodiscard]] tl::unexpected<Problem> fail(const Error& error);
[[nodiscard]] tl::unexpected<Problem> fail(RequestFault fault, std::string detail,
                                           std::string parameter = {});

/// 200 with JSON. Names from file systems may hold bytes that are not UTF-8; they become U+FFFD.
[[nodiscard]] Response json_answer(const nlohmann::json& json);

/// Where the models lie; nowhere while the index cannot be read.
[[nodiscard]] index::ModelRoots roots_of(Service& service);

/// A model as lists and pages have it: with its links, and its path below the roots.
[[nodiscard]] nlohmann::json model_json(const Service& service, const index::ModelRoots& roots,
                                        const index::ModelSummary& model);

/// Of a model's picture: another one, another version.
[[nodiscard]] std::string thumbnail_version(const index::ModelSummary& model);

/// A search answer; paths are those below the roots.
[[nodiscard]] nlohmann::json search_json(Service& service, const index::SearchResult& result,
                                         const index::QueryDescription& query,
                                         const ranking::RankOptions& options);

/// The same for a query that is kept under `token`, or not kept where that is empty.
[[nodiscard]] nlohmann::json query_search_json(Service& service, const index::SearchResult& result,
                                               const index::QueryModel& query,
                                               const std::string& token,
                                               std::optional<index::Up> up,
                                               const ranking::RankOptions& options);

/// The tag of a ranking: the answer says how long it took, so its own bytes make none; what it
/// depends on does.
[[nodiscard]] std::string ranking_tag(const Service& service, const index::Snapshot& snapshot,
                                      const RequestHead& head);

/// The rig of a preview.
Checked<Response> rig_answer(const Request& request, const index::PreviewMesh& preview,
                             const index::ModelSegments& segments,
                             const skeleton::SkeletonGraph& skeleton, std::string_view name);

/// That of a whole mesh, for whoever has a slot; and of the file of an indexed model.
Checked<Response> full_rig(const mesh::TriangleMesh& mesh, const std::string& name,
                           const Request& request);
Checked<Response> full_model_rig(Service& service, const Request& request);

/// Has browsers save the answer under that name.
[[nodiscard]] Response as_download(Response response, std::string_view file_name);

/// Refuses every parameter of a request that takes none.
[[nodiscard]] std::optional<Problem> refuse_parameters(const RequestHead& head);

/// The id of a `what` from the path of a request that takes no parameters.
[[nodiscard]] Checked<std::int64_t> only_id(const Request& request, std::string_view what);

/// A model that was uploaded raw or as the form's field `model`.
struct Upload {
    std::string_view bytes;
    std::string
        name;  ///< the parameter `name`, else the form's file name without ending, or upload
};
Checked<Upload> read_upload(const Request& request);

/// None when the content type is one that `read_upload` takes.
[[nodiscard]] std::optional<Problem> judge_media_type(const RequestHead& head);

/// Waits for a slot for heavy work.
Checked<Slots::Hold> wait_for_slot(Service& service, const Request& request);

}  // namespace ossuary::server
