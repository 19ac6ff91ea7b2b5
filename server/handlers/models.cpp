#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "index/content_hash.h"
#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

/// So that a cursor of one list is not taken for another's.
std::string filter_mark(const index::ModelFilter& filter) {
    constexpr std::size_t kDigits = 8;
    const std::string class_name = filter.class_name.value_or("");
    const std::string text =
        std::to_string(class_name.size()) + ' ' + class_name + filter.name_contains;
    return index::content_hash(text).substr(0, kDigits);
}

std::string to_cursor(index::ModelId after, const index::ModelFilter& filter) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), after, 16).ptr;
    return filter_mark(filter) + std::string(digits.begin(), end);
}

std::optional<index::ModelId> from_cursor(std::string_view cursor,
                                          const index::ModelFilter& filter) {
    const std::string mark = filter_mark(filter);
    if (!cursor.starts_with(mark)) return std::nullopt;
    cursor.remove_prefix(mark.size());
    std::int64_t after = 0;
    const char* end = cursor.data() + cursor.size();
    const auto parsed = std::from_chars(cursor.data(), end, after, 16);
    if (parsed.ec != std::errc() || parsed.ptr != end || after < 0) return std::nullopt;
    return after;
}

}  // namespace

nlohmann::json model_links(index::ModelId id) {
    const std::string base = "/v1/models/" + std::to_string(id);
    return {{"mesh", base + "/mesh"},
            {"skeleton", base + "/skeleton"},
            {"similar", base + "/similar"},
            {"thumbnail", base + "/thumbnail.png"}};
}

nlohmann::json model_json(const index::ModelSummary& model) {
    auto json = index::to_json(model);
    json["links"] = model_links(model.id);
    return json;
}

Checked<Response> list_models(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    index::ModelFilter filter;
    filter.limit = static_cast<std::size_t>(reader.integer("limit", 1, 500).value_or(50));
    filter.class_name = reader.text("class");
    filter.name_contains = reader.text("name").value_or("");
    if (const auto cursor = reader.text("cursor")) {
        const auto after = from_cursor(*cursor, filter);
        if (!after) reader.refuse("cursor", "`cursor` is not one that this list gave.");
        filter.after = after.value_or(0);
    }
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));

    const auto page = service.searcher.store().models(filter);
    if (!page) return fail(page.error());
    auto models = nlohmann::json::array();
    for (const index::ModelSummary& model : page->models) {
        models.push_back(model_json(model));
    }
    nlohmann::json json = {{"models", std::move(models)},
                           {"next_cursor", nullptr},
                           {"total", page->total},
                           {"revision", page->revision}};
    if (page->next) json["next_cursor"] = to_cursor(*page->next, filter);
    return conditional(request.head, json_answer(json));
}

Checked<Response> get_model(Service& service, const Request& request) {
    const auto id = only_id(request, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    return conditional(request.head, json_answer(model_json(*model)));
}

}  // namespace ossuary::server
