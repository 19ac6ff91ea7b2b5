#include <nlohmann/json.hpp>

#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {

std::string ranking_tag(const Service& service, const index::Snapshot& snapshot,
                        const RequestHead& head) {
    std::string key = service.instance + ' ' + std::to_string(snapshot.state().replacements) + ' ' +
                      std::to_string(snapshot.revision()) + ' ' +
                      std::to_string(snapshot.state().statistics) + ' ' + head.path;
    for (const Field& field : head.parameters) key += '\n' + field.name + '=' + field.value;
    return etag_of(key);
}

Checked<Response> similar(Service& service, const Request& request) {
    const auto id = parse_id(request.capture, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    ParameterReader reader(request.head);
    const index::SearchOptions options = read_search_options(reader);
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));

    const auto snapshot = service.searcher.snapshot();
    if (!snapshot) return fail(snapshot.error());
    if (!(*snapshot)->find(*id)) {
        return fail({ErrorCode::kModelNotFound, "There is no model " + request.capture + "."});
    }
    std::string etag = ranking_tag(service, **snapshot, request.head);
    if (is_current(request.head, etag)) return not_modified(std::move(etag));

    const auto slot = wait_for_slot(service, request);
    if (!slot) return tl::unexpected<Problem>(slot.error());
    const auto result = service.searcher.similar(*id, options, request.stop);
    if (!result) return fail(result.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    return conditional(
        request.head,
        json_answer(search_json(service, *result,
                                {model->name, model->vertices, model->faces, model->frame},
                                options.rank)),
        std::move(etag));
}

}  // namespace ossuary::server
