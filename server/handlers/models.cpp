#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "index/catalogue.h"
#include "index/content_hash.h"
#include "index/number_ranges.h"
#include "index/presentation.h"
#include "server/etag.h"
#include "server/handlers/handlers.h"
#include "server/parameters.h"

namespace ossuary::server {
namespace {

/// So that a cursor of one list is not taken for another's.
std::string filter_mark(const index::CatalogueFilter& filter) {
    constexpr std::size_t kDigits = 8;
    std::string text;
    for (const auto& each : {filter.class_name, filter.folder, filter.kind, filter.branches,
                             filter.loops, filter.extent, filter.unit}) {
        text += each ? std::to_string(each->size()) + ' ' + *each : "-";
    }
    return index::content_hash(text + filter.name_contains).substr(0, kDigits);
}

std::string to_cursor(index::ModelId after, const index::CatalogueFilter& filter) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), after, 16).ptr;
    return filter_mark(filter) + std::string(digits.begin(), end);
}

std::optional<index::ModelId> from_cursor(std::string_view cursor,
                                          const index::CatalogueFilter& filter) {
    const std::string mark = filter_mark(filter);
    if (!cursor.starts_with(mark)) return std::nullopt;
    cursor.remove_prefix(mark.size());
    std::int64_t after = 0;
    const char* end = cursor.data() + cursor.size();
    const auto parsed = std::from_chars(cursor.data(), end, after, 16);
    if (parsed.ec != std::errc() || parsed.ptr != end || after < 0) return std::nullopt;
    return after;
}

index::CatalogueFilter read_filter(ParameterReader& reader) {
    index::CatalogueFilter filter;
    filter.class_name = reader.text("class");
    filter.name_contains = reader.text("name").value_or("");
    filter.folder = reader.text("folder", 1024);
    filter.kind = reader.text("kind", 16);
    filter.branches =
        reader.choice("branches", {index::kBranchRanges.begin(), index::kBranchRanges.end()});
    filter.loops = reader.choice("loops", {index::kLoopRanges.begin(), index::kLoopRanges.end()});
    const auto extents = index::extent_ranges();
    filter.extent = reader.choice("extent", {extents.begin(), extents.end()});
    filter.unit = reader.text("unit", 32);
    return filter;
}

index::CatalogueOrder read_order(ParameterReader& reader) {
    using enum index::CatalogueOrder;
    constexpr std::array<std::pair<std::string_view, index::CatalogueOrder>, 5> kOrders = {
        {{"id", kId},
         {"name", kName},
         {"newest", kNewest},
         {"faces", kFaces},
         {"branches", kBranches}}};
    std::vector<std::string_view> names;
    for (const auto& [name, order] : kOrders) names.push_back(name);
    const std::string chosen = reader.choice("sort", names).value_or("id");
    return std::find_if(kOrders.begin(), kOrders.end(),
                        [&](const auto& each) { return each.first == chosen; })
        ->second;
}

/// What a page of the list is asked by.
struct ListRequest {
    index::CatalogueFilter filter;
    index::CatalogueOrder order = index::CatalogueOrder::kId;
    std::size_t limit = 0;
    std::size_t offset = 0;
    std::optional<index::ModelId> after;  ///< with a cursor: only ids above
};

Checked<ListRequest> read_list_request(const RequestHead& head) {
    ParameterReader reader(head);
    ListRequest list;
    list.limit = static_cast<std::size_t>(reader.integer("limit", 1, 500).value_or(50));
    list.filter = read_filter(reader);
    list.order = read_order(reader);
    constexpr std::int64_t kMost = std::int64_t{1} << 40;
    const auto offset = reader.integer("offset", 0, kMost);
    list.offset = static_cast<std::size_t>(offset.value_or(0));
    if (const auto cursor = reader.text("cursor")) {
        list.after = from_cursor(*cursor, list.filter);
        if (!list.after || offset || list.order != index::CatalogueOrder::kId) {
            reader.refuse("cursor", "`cursor` is not one that this list gave.");
        }
    }
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    return list;
}

/// A value of a facet; null for the models that have none.
nlohmann::json values_json(const std::vector<index::FacetValue>& values) {
    auto list = nlohmann::json::array();
    for (const index::FacetValue& each : values) {
        list.push_back(
            {{"value", each.value.empty() ? nlohmann::json() : nlohmann::json(each.value)},
             {"models", each.models}});
    }
    return list;
}

}  // namespace

Checked<Response> list_models(Service& service, const Request& request) {
    const auto list = read_list_request(request.head);
    if (!list) return tl::unexpected<Problem>(list.error());
    const auto snapshot = service.searcher.snapshot();
    if (!snapshot) return fail(snapshot.error());
    const auto store = service.searcher.stores().lend();
    if (!store) return fail(store.error());
    const auto found = index::list_models(**snapshot, **store, list->filter, list->order);
    if (!found) return fail(found.error());
    std::size_t first = std::min(list->offset, found->size());
    if (list->after) {
        first = static_cast<std::size_t>(std::partition_point(found->begin(), found->end(),
                                                              [&](std::size_t at) {
                                                                  return (*snapshot)->id(at) <=
                                                                         *list->after;
                                                              }) -
                                         found->begin());
    }
    const std::size_t end = std::min(first + list->limit, found->size());
    auto page = nlohmann::json::array();
    for (std::size_t i = first; i < end; ++i) {
        const auto model = (*store)->model((*snapshot)->id((*found)[i]));
        if (!model && model.error().code == ErrorCode::kModelNotFound) continue;  // gone since
        if (!model) return fail(model.error());
        page.push_back(model_json(service, (*snapshot)->roots(), *model));
    }
    nlohmann::json json = {{"models", std::move(page)},
                           {"next_cursor", nullptr},
                           {"total", found->size()},
                           {"revision", (*snapshot)->revision()}};
    if (end < found->size() && end > first && list->order == index::CatalogueOrder::kId) {
        json["next_cursor"] = to_cursor((*snapshot)->id((*found)[end - 1]), list->filter);
    }
    return conditional(request.head, json_answer(json));
}

Checked<Response> list_facets(Service& service, const Request& request) {
    ParameterReader reader(request.head);
    const index::CatalogueFilter filter = read_filter(reader);
    const bool with_loops = reader.choice("include", {"loops"}).has_value();
    if (auto fault = reader.finish()) return tl::unexpected<Problem>(*std::move(fault));
    const auto snapshot = service.searcher.snapshot();
    if (!snapshot) return fail(snapshot.error());
    const auto store = service.searcher.stores().lend();
    if (!store) return fail(store.error());
    const auto facets = index::count_facets(**snapshot, **store, filter, with_loops);
    if (!facets) return fail(facets.error());
    nlohmann::json json = {
        {"classes", values_json(facets->classes)}, {"folders", values_json(facets->folders)},
        {"kinds", values_json(facets->kinds)},     {"branches", values_json(facets->branches)},
        {"extents", values_json(facets->extents)}, {"units", values_json(facets->units)},
        {"revision", (*snapshot)->revision()}};
    if (with_loops) json["loops"] = values_json(facets->loops);
    return conditional(request.head, json_answer(json));
}

Checked<Response> get_model(Service& service, const Request& request) {
    const auto id = only_id(request, "model");
    if (!id) return tl::unexpected<Problem>(id.error());
    const auto model = service.searcher.store().model(*id);
    if (!model) return fail(model.error());
    return conditional(request.head, json_answer(model_json(service, roots_of(service), *model)));
}

}  // namespace ossuary::server
