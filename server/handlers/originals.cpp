// What is made from the files that were indexed, rather than from the index.

#include <nlohmann/json.hpp>

#include "engine/decomposition/decompose.h"
#include "engine/mesh/write_mesh.h"
#include "index/describe_model.h"
#include "index/model_place.h"
#include "index/model_segments.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

/// RFC 6266 with the encoding of RFC 8187, which takes any name.
std::string attachment(std::string_view file_name) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    constexpr std::string_view kPlain = "!#$&+-.^_`|~";
    std::string text = "attachment; filename*=UTF-8''";
    for (const char c : file_name) {
        const bool letter = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                            (c >= 'a' && c <= 'z') || kPlain.find(c) != std::string_view::npos;
        if (letter) {
            text += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            text += '%';
            text += kDigits[byte >> 4];
            text += kDigits[byte & 15];
        }
    }
    return text;
}

struct Original {
    Slots::Hold slot;  ///< held while it is worked on
    index::ModelSummary summary;
    index::ModelPlace place;
    index::ModelBytes model;
};

tl::unexpected<Problem> not_available(std::string_view id, std::string_view why) {
    return fail(RequestFault::kOriginalNotAvailable,
                "The file of model " + std::string(id) + " " + std::string(why) + ".");
}

/// The bytes that a model was indexed from, should they still be there; waits for a slot first.
Checked<Original> open_original(Service& service, const Request& request) {
    auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    const auto id = parse_id(request.capture, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    auto summary = service.searcher.store().model(*id);
    if (!summary) return fail(summary.error());
    if (!service.options.serve_files) {
        return not_available(request.capture, "is not served; the server can be told to");
    }
    if (summary->path.empty()) return not_available(request.capture, "was uploaded and not kept");
    const std::uint64_t max_bytes = mesh::ReadMeshOptions{}.max_bytes;
    auto model = service.reader.open(summary->path, max_bytes, request.stop);
    if (!model && model.error().code == ErrorCode::kCancelled) return fail(model.error());
    if (!model) return not_available(request.capture, "is not where it was any more");
    index::ModelSource source{model->bytes.view(), model->name};
    source.reader = &service.reader;
    source.companions = model->companions;
    source.object = model->object;
    if (index::model_hash(source) != summary->content_hash) {
        return not_available(request.capture, "has changed since it was indexed");
    }
    index::ModelPlace place = index::place_of(summary->path);
    return Original{*std::move(slot), *std::move(summary), std::move(place), *std::move(model)};
}

Result<mesh::ReadMeshResult> read_original(Service& service, const Original& original,
                                           const std::stop_token& stop) {
    const index::ModelBytes& model = original.model;
    return service.reader.read({model.bytes.view(), model.name, model.companions, model.object}, {},
                               stop);
}

}  // namespace

Response as_download(Response response, std::string_view file_name) {
    response.set_header("Content-Disposition", attachment(file_name));
    return response;
}

Checked<Response> model_file(Service& service, const Request& request) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    const auto original = open_original(service, request);
    if (!original) return tl::unexpected<Problem>(original.error());
    return as_download(conditional(request.head, answer("application/octet-stream",
                                                        std::string(original->model.bytes.view()))),
                       original->place.file_name().string());
}

Checked<Response> model_stl(Service& service, const Request& request) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    const auto original = open_original(service, request);
    if (!original) return tl::unexpected<Problem>(original.error());
    const auto read = read_original(service, *original, request.stop);
    if (!read) return fail(read.error());
    return as_download(conditional(request.head, answer("model/stl", mesh::to_stl(read->mesh))),
                       original->summary.name + ".stl");
}

Checked<Response> full_model_rig(Service& service, const Request& request) {
    const auto original = open_original(service, request);
    if (!original) return tl::unexpected<Problem>(original.error());
    const auto read = read_original(service, *original, request.stop);
    if (!read) return fail(read.error());
    return full_rig(read->mesh, original->summary.name, request);
}

Checked<Response> full_rig(const mesh::TriangleMesh& mesh, const std::string& name,
                           const Request& request) {
    const auto parts = decomposition::decompose(mesh, {}, request.stop);
    if (!parts) return fail(parts.error());
    auto rig = index::mesh_rig(mesh, *parts, name, request.stop);
    if (!rig) return fail(rig.error());
    return as_download(conditional(request.head, answer("model/gltf-binary", *std::move(rig))),
                       name + ".glb");
}

}  // namespace ossuary::server
