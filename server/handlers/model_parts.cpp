#include <nlohmann/json.hpp>

#include "index/model_segments.h"
#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"

namespace ossuary::server {
namespace {

/// The parts that the index holds of a model; where it holds none, why.
Checked<index::ModelSegments> stored_segments(Service& service, index::ModelId id) {
    auto segments = service.searcher.store().segments(id);
    if (!segments) return fail(segments.error());
    if (*segments) return **std::move(segments);
    const auto model = service.searcher.store().model(id);
    if (!model) return fail(model.error());
    std::string detail =
        "Model " + std::to_string(id) + " could not be cut into parts when it was indexed";
    for (const mesh::MeshWarning& warning : model->warnings) {
        if (warning.code == index::kSegmentsMissing) detail += ": " + warning.message;
    }
    return fail(RequestFault::kSegmentsNotAvailable, detail);
}

}  // namespace

Checked<Response> model_mesh(Service& service, const Request& request) {
    const auto id = only_id(request, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    const auto mesh = service.searcher.store().preview(*id);
    if (!mesh) return fail(mesh.error());
    return conditional(request.head, json_answer(index::to_json(*mesh, model->bounds)));
}

Checked<Response> model_skeleton(Service& service, const Request& request) {
    const auto id = only_id(request, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto skeleton = service.searcher.store().skeleton(*id);
    if (!skeleton) return fail(skeleton.error());
    return conditional(request.head, json_answer(index::to_json(*skeleton)));
}

Checked<Response> model_segments(Service& service, const Request& request) {
    const auto id = only_id(request, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto segments = stored_segments(service, *id);
    if (!segments) return tl::unexpected<Problem>(segments.error());
    return conditional(request.head, json_answer(index::to_json(*segments)));
}

Checked<Response> rig_answer(const Request& request, const index::PreviewMesh& preview,
                             const index::ModelSegments& segments,
                             const skeleton::SkeletonGraph& skeleton, std::string_view name) {
    auto rig = index::model_rig(preview, segments, skeleton, name, request.stop);
    if (!rig.ok()) return fail(rig.error());
    return conditional(request.head, answer("model/gltf-binary", *std::move(rig)));
}

Checked<Response> model_rig(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const bool full = reader.choice("detail", {"full"}).has_value();
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    if (full) return full_model_rig(service, request);
    const auto id = parse_id(request.capture, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    const auto segments = stored_segments(service, *id);
    if (!segments) return tl::unexpected<Problem>(segments.error());
    const auto mesh = service.searcher.store().preview(*id);
    if (!mesh) return fail(mesh.error());
    const auto skeleton = service.searcher.store().skeleton(*id);
    if (!skeleton) return fail(skeleton.error());
    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    return rig_answer(request, *mesh, *segments, skeleton->graph, model->name);
}

Checked<Response> model_thumbnail(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const auto version = reader.text("v", 64);
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    const auto id = parse_id(request.capture, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    const auto picture = service.searcher.store().thumbnail(*id);
    if (!picture) return fail(picture.error());
    if (picture->empty()) {
        return fail(RequestFault::kThumbnailNotAvailable,
                    "The index holds no picture of model " + request.capture + ".");
    }
    Response response = answer("image/png", std::string(picture->begin(), picture->end()));
    if (version != thumbnail_version(*model)) {
        return conditional(request.head, std::move(response));
    }
    // This address never shows anything else.
    response.set_header("ETag", etag_of(response.body));
    response.set_header("Cache-Control", "private, max-age=31536000, immutable");
    return response;
}

}  // namespace ossuary::server
