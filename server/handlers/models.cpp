#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

/// FNV-1a, so that a cursor of one list is not taken for another's.
std::uint32_t filter_hash(const index::ModelFilter& filter) {
    std::uint32_t hash = 2166136261u;
    const auto add = [&hash](std::string_view text) {
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
        hash = (hash ^ 0x100u) * 16777619u;  // the end: no byte has this value
    };
    add(filter.class_name.value_or(""));
    add(filter.name_contains);
    return hash;
}

std::string to_cursor(index::ModelId after, const index::ModelFilter& filter) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%08x%llx", filter_hash(filter),
                  static_cast<unsigned long long>(after));
    return text.data();
}

std::optional<index::ModelId> from_cursor(std::string_view cursor,
                                          const index::ModelFilter& filter) {
    constexpr std::size_t kHash = 8;
    std::uint32_t hash = 0;
    std::int64_t after = 0;
    if (cursor.size() <= kHash) return std::nullopt;
    const char* middle = cursor.data() + kHash;
    const char* end = cursor.data() + cursor.size();
    const auto first = std::from_chars(cursor.data(), middle, hash, 16);
    const auto second = std::from_chars(middle, end, after, 16);
    if (first.ec != std::errc() || first.ptr != middle || second.ec != std::errc() ||
        second.ptr != end || hash != filter_hash(filter) || after < 0) {
        return std::nullopt;
    }
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
    if (auto fault = refuse_parameters(request.head)) {
        return tl::unexpected<Problem>(*std::move(fault));
    }
    const auto id = parse_id(request.capture, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    return conditional(request.head, json_answer(model_json(*model)));
}

}  // namespace ossuary::server
