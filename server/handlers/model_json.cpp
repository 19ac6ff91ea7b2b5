#include <nlohmann/json.hpp>

#include "index/content_hash.h"
#include "index/presentation.h"
#include "server/handlers/handlers.h"

namespace ossuary::server {

std::string thumbnail_version(const index::ModelSummary& model) {
    constexpr std::size_t kDigits = 12;
    return index::content_hash(model.content_hash + ' ' + model.indexed_at + ' ' +
                               std::string(to_string(model.orientation.up)))
        .substr(0, kDigits);
}

index::ModelRoots roots_of(Service& service) {
    const auto snapshot = service.searcher.snapshot();
    return snapshot ? (*snapshot)->roots() : index::ModelRoots();
}

nlohmann::json model_json(const Service& service, const index::ModelRoots& roots,
                          const index::ModelSummary& model) {
    const std::string base =
        service.options.http.base_path + "/v1/models/" + std::to_string(model.id);
    nlohmann::json json = index::to_json(model);
    json["path"] = roots.relative(model.path);
    json["links"] = {{"mesh", base + "/mesh"},
                     {"skeleton", base + "/skeleton"},
                     {"segments", base + "/segments"},
                     {"rig", base + "/rig.glb"},
                     {"similar", base + "/similar"},
                     {"thumbnail", base + "/thumbnail.png?v=" + thumbnail_version(model)}};
    if (service.options.serve_files && !model.path.empty()) {
        json["links"]["file"] = base + "/file";
        json["links"]["stl"] = base + "/mesh.stl";
    }
    if (!service.options.embedders.empty()) {
        json["links"]["embed"] =
            service.options.http.base_path + "/embed.html#/models/" + std::to_string(model.id);
    }
    return json;
}

nlohmann::json search_json(Service& service, const index::SearchResult& result,
                           const index::QueryDescription& query,
                           const ranking::RankOptions& options) {
    nlohmann::json json = index::to_json(result, query, options);
    const index::ModelRoots roots = roots_of(service);
    const auto store = service.searcher.stores().lend();
    for (nlohmann::json& hit : json["hits"]) {
        hit["path"] = roots.relative(hit["path"].get<std::string>());
        // Which way a model stands may have changed without a new revision; it may be gone, too.
        const auto model = store ? (*store)->model(hit["id"].get<index::ModelId>())
                                 : Result<index::ModelSummary>(store.error());
        const std::string picture = service.options.http.base_path + "/v1/models/" +
                                    std::to_string(hit["id"].get<index::ModelId>()) +
                                    "/thumbnail.png";
        hit["thumbnail"] = model ? picture + "?v=" + thumbnail_version(*model) : picture;
    }
    return json;
}

}  // namespace ossuary::server
