#include <nlohmann/json.hpp>

#include "engine/voxel/read_model.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

/// Why a job failed, as far as it concerns its client: what the server is at fault for may name
/// files of this machine.
nlohmann::json job_error(const index::UploadRecord& job) {
    std::string message = job.message;
    for (const ErrorCodeName& name : kErrorCodeNames) {
        if (name.name == job.code && problem_row(name.code).status == 500 &&
            name.code != ErrorCode::kUploadAbandoned) {
            message = "The server could not do this; its log says why under the job's number.";
        }
    }
    return {{"code", job.code}, {"message", message}};
}

nlohmann::json job_json(const index::UploadRecord& job) {
    nlohmann::json json = {
        {"id", job.id}, {"state", to_string(job.state)}, {"model", nullptr}, {"error", nullptr}};
    if (job.state == index::UploadState::kDone) json["model"] = job.model;
    if (job.state == index::UploadState::kFailed) json["error"] = job_error(job);
    return json;
}

/// @param axis x, y, z or auto
Checked<index::Orientation> turn(Service& service, index::ModelId id, const std::string& axis) {
    std::optional<index::Up> up;
    if (axis != "auto") {
        const auto parsed = index::parse_up(axis);
        if (!parsed) return fail(parsed.error());
        up = *parsed;
    }
    const auto turned = service.jobs->turn(id, up);
    if (!turned) return fail(turned.error());
    return *turned;
}

}  // namespace

Checked<Response> list_failures(Service& service, const Request& request) {
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    const auto failures = service.searcher.store().failures();
    if (!failures) return fail(failures.error());
    const index::ModelRoots roots = roots_of(service);
    auto list = nlohmann::json::array();
    for (index::Failure failure : *failures) {
        // Messages name the file as the indexer did: whole.
        const std::string relative = roots.relative(failure.path);
        for (auto at = failure.message.find(failure.path);
             at != std::string::npos && !failure.path.empty();
             at = failure.message.find(failure.path, at + relative.size())) {
            failure.message.replace(at, failure.path.size(), relative);
        }
        failure.path = relative;
        list.push_back(index::to_json(failure));
    }
    Response response = json_answer({{"failures", std::move(list)}});
    response.set_header("Cache-Control", "no-store");
    return response;
}

std::optional<Problem> check_add_model(const Service&, const RequestHead& head) {
    ParameterReader reader(head);
    reader.text("name");
    reader.text("class");
    read_inside(reader);
    if (auto fault = reader.finish()) return fault;
    return judge_media_type(head);
}

Checked<Response> add_model(Service& service, const Request& request) {
    const auto upload = read_upload(request);
    if (!upload) return tl::unexpected<Problem>(upload.error());
    // A file that cannot be read is refused here and now rather than in a job later.
    ParameterReader parameters(request.head);
    voxel::ReadModelOptions reading{.inside = read_inside(parameters)};
    reading.mesh.max_bytes = service.options.http.max_body;
    const auto mesh = service.reader.read({upload->bytes, upload->name, {}}, reading, request.stop);
    if (!mesh) return fail(mesh.error());

    const std::string* class_name = find_field(request.head.parameters, "class");
    const auto job =
        service.jobs->add({std::string(upload->bytes), upload->name,
                           class_name == nullptr ? std::string() : *class_name, reading.inside});
    if (!job) return fail(job.error());
    if (!*job) return fail(RequestFault::kOverloaded, "Too many models wait to be indexed.");
    const std::string location =
        service.options.http.base_path + "/v1/jobs/" + std::to_string(**job);
    Response response = json_answer({{"job", location}});
    response.status = 202;
    response.set_header("Location", location);
    response.set_header("Cache-Control", "no-store");
    return response;
}

Checked<Response> change_model(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const std::string* class_name = find_field(request.head.parameters, "class");
    if (class_name == nullptr) reader.require("up");
    reader.text("class", 256, 0);
    const auto axis = reader.choice("up", {"x", "y", "z", "auto"});
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    const auto id = parse_id(request.capture, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    if (class_name != nullptr) {
        const auto classified = service.jobs->classify(*id, *class_name);
        if (!classified) return fail(classified.error());
    }
    if (axis) {
        const auto turned = turn(service, *id, *axis);
        if (!turned) return tl::unexpected<Problem>(turned.error());
    }
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    Response response = json_answer(model_json(service, roots_of(service), *model));
    response.set_header("Cache-Control", "no-store");
    return response;
}

Checked<Response> remove_model(Service& service, const Request& request) {
    const auto id = only_id(request, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    if (const auto removed = service.jobs->remove(*id); !removed) return fail(removed.error());
    Response response;
    response.status = 204;
    return response;
}

Checked<Response> list_jobs(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const auto limit = static_cast<std::size_t>(
        reader.integer("limit", 1, index::kRememberedUploads).value_or(50));
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    const auto jobs = service.searcher.store().uploads(limit);
    if (!jobs) return fail(jobs.error());
    auto list = nlohmann::json::array();
    for (const index::UploadRecord& job : *jobs) {
        const auto or_null = [](const std::string& text) {
            return text.empty() ? nlohmann::json() : nlohmann::json(text);
        };
        nlohmann::json json = job_json(job);
        json["name"] = job.name;
        json["class"] = or_null(job.class_name);
        json["size"] = job.size;
        json["accepted_at"] = job.accepted_at;
        json["finished_at"] = or_null(job.finished_at);
        list.push_back(std::move(json));
    }
    Response response = json_answer({{"jobs", std::move(list)}});
    response.set_header("Cache-Control", "no-store");
    return response;
}

Checked<Response> get_job(Service& service, const Request& request) {
    const auto id = only_id(request, "job");
    if (!id) return tl::unexpected<Problem>(id.error());
    // In the index, so that it is known whichever server did the work.
    const auto job = service.searcher.store().upload(*id);
    if (!job) return fail(job.error());
    if (!*job) {
        return fail(RequestFault::kJobNotFound, "There is no job " + request.capture + ".");
    }
    Response response = json_answer(job_json(**job));
    response.set_header("Cache-Control", "no-store");
    return response;
}

}  // namespace ossuary::server
