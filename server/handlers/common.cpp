#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "index/json_text.h"
#include "server/handlers/handlers.h"
#include "server/multipart.h"
#include "server/parameters.h"

namespace ossuary::server {

tl::unexpected<Problem> fail(const Error& error) {
    // The one thing that cancels is a request's own stop token.
    if (error.code == ErrorCode::kCancelled) {
        return fail(RequestFault::kSearchTimeout, "This took longer than a request may take.");
    }
    return tl::unexpected<Problem>(problem(error));
}

tl::unexpected<Problem> fail(RequestFault fault, std::string detail, std::string parameter) {
    return tl::unexpected<Problem>(problem(fault, std::move(detail), std::move(parameter)));
}

Response json_answer(const nlohmann::json& json) {
    return answer("application/json", index::json_text(json));
}

std::optional<Problem> refuse_parameters(const RequestHead& head) {
    return ParameterReader(head).finish();
}

Checked<std::int64_t> only_id(const Request& request, std::string_view what) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    return parse_id(request.capture, what);
}

std::optional<Problem> judge_media_type(const RequestHead& head) {
    const std::string type = media_type(head.header("Content-Type"));
    // Besides those of model/: what systems and programs call STL, OBJ, PLY, 3MF and packed files.
    constexpr std::array<std::string_view, 12> kTypes = {
        "",
        "multipart/form-data",
        "application/octet-stream",
        "text/plain",
        "text/prs.wavefront-obj",
        "application/vnd.ms-pki.stl",
        "application/sla",
        "application/vnd.ms-package.3dmanufacturing-3dmodel+xml",
        "application/gzip",
        "application/x-gzip",
        "application/zip",
        "application/x-zip-compressed"};
    if (type.starts_with("model/") ||
        std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end()) {
        return std::nullopt;
    }
    return problem(
        RequestFault::kMediaTypeUnsupported,
        "Send the model as application/octet-stream, text/plain, model/* or as the field "
        "`model` of multipart/form-data.");
}

Checked<Upload> read_upload(const Request& request) {
    const std::string content_type = request.head.header("Content-Type");
    Upload upload{request.body, "upload"};
    if (media_type(content_type) == "multipart/form-data") {
        auto form = parse_form(content_type, request.body);
        if (!form) return tl::unexpected<Problem>(std::move(form.error()));
        const FormPart* model = nullptr;
        for (const FormPart& part : *form) {
            if (part.name != "model" || model != nullptr) {
                return fail(
                    RequestFault::kMultipartInvalid,
                    "The form must have one field, `model`; it also has `" + part.name + "`.");
            }
            model = &part;
        }
        if (model == nullptr) {
            return fail(RequestFault::kMultipartInvalid, "The form has no field `model`.");
        }
        upload.bytes = model->content;
        const std::string stem = model->file_name.substr(0, model->file_name.rfind('.'));
        if (!stem.empty()) upload.name = stem;
    }
    if (const std::string* name = find_field(request.head.parameters, "name")) upload.name = *name;
    if (upload.bytes.empty()) {
        return fail(RequestFault::kBodyEmpty, "The request has no model in its body.");
    }
    return upload;
}

Checked<Slots::Hold> wait_for_slot(Service& service, const Request& request) {
    service.metrics.searches_waiting(service.slots.waiting() + 1);
    auto outcome = service.slots.acquire(request.stop);
    service.metrics.searches_waiting(service.slots.waiting());
    if (outcome.hold) return *std::move(outcome.hold);
    if (outcome.refusal == Slots::Refusal::kStopped) {
        return fail(RequestFault::kSearchTimeout, "No slot became free in time.");
    }
    return fail(RequestFault::kOverloaded, "Too many searches are waiting.");
}

}  // namespace ossuary::server
