#include <nlohmann/json.hpp>

#include "index/model_segments.h"
#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

/// The model's id from the path of a request that takes no parameters.
Checked<index::ModelId> only_id(const Request& request) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    return parse_id(request.capture, "model");
}

/// What the index keeps of a model that it can be cut into parts by.
struct ShapeToCut {
    std::string name;
    index::PreviewMesh mesh;
    SkeletonGraph skeleton;
};

Checked<ShapeToCut> shape_to_cut(Service& service, const Request& request) {
    const auto id = only_id(request);
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    auto mesh = service.searcher.store().preview(*id);
    if (!mesh) return fail(mesh.error());
    auto skeleton = service.searcher.store().skeleton(*id);
    if (!skeleton) return fail(skeleton.error());
    return ShapeToCut{model->name, *std::move(mesh), std::move(skeleton->graph)};
}

tl::unexpected<Problem> not_cut(const Request& request, const Error& error) {
    if (error.code == ErrorCode::kCancelled) return fail(error);
    return fail(RequestFault::kSegmentsNotAvailable,
                "Model " + request.capture + " cannot be cut into parts: " + error.message);
}

}  // namespace

Checked<Response> model_mesh(Service& service, const Request& request) {
    const auto id = only_id(request);
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    const auto mesh = service.searcher.store().preview(*id);
    if (!mesh) return fail(mesh.error());
    return conditional(request.head, json_answer(index::to_json(*mesh, model->bounds)));
}

Checked<Response> model_skeleton(Service& service, const Request& request) {
    const auto id = only_id(request);
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto skeleton = service.searcher.store().skeleton(*id);
    if (!skeleton) return fail(skeleton.error());
    return conditional(request.head, json_answer(index::to_json(*skeleton)));
}

Checked<Response> model_segments(Service& service, const Request& request) {
    const auto shape = shape_to_cut(service, request);
    if (!shape) return tl::unexpected<Problem>(shape.error());
    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    const auto segments = index::model_segments(shape->mesh, shape->skeleton, request.stop);
    if (!segments.ok()) return not_cut(request, segments.error());
    return conditional(request.head, json_answer(index::to_json(*segments)));
}

Checked<Response> model_rig(Service& service, const Request& request) {
    const auto shape = shape_to_cut(service, request);
    if (!shape) return tl::unexpected<Problem>(shape.error());
    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    auto rig = index::model_rig(shape->mesh, shape->skeleton, shape->name, request.stop);
    if (!rig.ok()) return not_cut(request, rig.error());
    return conditional(request.head, answer("model/gltf-binary", *std::move(rig)));
}

Checked<Response> model_thumbnail(Service& service, const Request& request) {
    const auto id = only_id(request);
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto picture = service.searcher.store().thumbnail(*id);
    if (!picture) return fail(picture.error());
    if (picture->empty()) {
        return fail(RequestFault::kThumbnailNotAvailable,
                    "The index holds no picture of model " + request.capture + ".");
    }
    return conditional(request.head,
                       answer("image/png", std::string(picture->begin(), picture->end())));
}

}  // namespace ossuary::server
