#include "index/pose_gallery.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <map>

#include "engine/core/whole_file.h"
#include "index/report_text.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kGalleryStyle = R"(
body { font: 15px/1.5 system-ui, sans-serif; color: #1d232b; margin: 2rem auto; max-width: 76rem;
       padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; }
.examples { display: flex; flex-wrap: wrap; gap: 1.5rem; }
table { border-collapse: collapse; } th { font-weight: 600; font-size: .8rem; }
td { text-align: center; font-size: .75rem; color: #5a6470; }
img { width: 7rem; height: 7rem; object-fit: contain; display: block; }
)";

/// RFC 4648, sec. 4.
std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            group = group << 8 | (i < count ? bytes[at + i] : std::uint8_t{0});
        }
        for (std::size_t i = 0; i < 4; ++i) {
            text += i <= count ? kDigits[group >> (18 - 6 * i) & 63] : '=';
        }
    }
    return text;
}

/// The nearest other member of each of a class' members.
std::vector<std::size_t> nearest_members(ranking::DescriptorSpan members,
                                         const ranking::CollectionStatistics& statistics,
                                         double pose, int jobs) {
    ranking::RankOptions options;
    options.ranker = ranking::RankerKind::kSkeleton;
    options.pose = pose;
    options.jobs = jobs;
    const ranking::DistanceMatrix distances =
        *ranking::distance_matrix(members, statistics, options);  // no stop
    std::vector<std::size_t> nearest;
    for (std::size_t i = 0; i < members.size(); ++i) {
        std::size_t best = i == 0 ? 1 : 0;
        for (std::size_t j = 0; j < members.size(); ++j) {
            if (j != i && distances.at(i, j) < distances.at(i, best)) best = j;
        }
        nearest.push_back(best);
    }
    return nearest;
}

Result<std::string> picture(Store& store, ModelId id) {
    const auto model = store.model(id);
    if (!model) return model.error();
    const std::string name = markup_text(model->name);
    const auto png = store.thumbnail(id);
    if (!png && png.error().code != ErrorCode::kModelNotFound) return png.error();
    if (!png || png->empty()) return "<td>" + name + "</td>";
    return "<td><img alt=\"" + name + "\" src=\"data:image/png;base64," + base64(*png) + "\">" +
           name + "</td>";
}

}  // namespace

Result<std::vector<PoseExample>> pose_examples(const Snapshot& snapshot, StorePool& stores,
                                               const Evaluation& evaluation, std::size_t per_class,
                                               int jobs) {
    assert(evaluation.labels.size() == evaluation.order.size());
    std::map<std::string, std::vector<ModelId>> classes;
    for (std::size_t i = 0; i < evaluation.order.size(); ++i) {
        classes[evaluation.labels[i]].push_back(evaluation.order[i]);
    }
    std::vector<PoseExample> examples;
    for (const auto& [name, ids] : classes) {
        if (ids.size() < 3 || name.empty() || name == "-1") continue;
        std::vector<std::size_t> positions;
        for (const ModelId id : ids) positions.push_back(snapshot.find(id).value());
        const auto loaded = load_descriptors(snapshot, stores, positions, jobs);
        if (!loaded) return loaded.error();
        std::vector<const descriptor::ModelDescriptor*> members;
        for (const ranking::SharedDescriptor& model : *loaded) members.push_back(model.get());
        const auto by_build = nearest_members(members, snapshot.statistics(), 0.0, jobs);
        const auto by_pose = nearest_members(members, snapshot.statistics(), 1.0, jobs);
        const std::size_t count = std::min(per_class, ids.size());
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = k * ids.size() / count;
            examples.push_back({name, ids[i], ids[by_build[i]], ids[by_pose[i]]});
        }
    }
    return examples;
}

Result<std::string> pose_gallery_html(Store& store, std::span<const PoseExample> examples,
                                      const std::string& before) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\"><title>Poses</title><style>" +
        std::string(kGalleryStyle) + "</style></head><body>\n<h1>Poses</h1>\n" + before +
        "<p>Models beside the nearest of their own class "
        "under <code>skeleton</code>: by build alone (pose 0), and by pose alone (pose "
        "1).</p>\n";
    const std::string* last = nullptr;
    for (const PoseExample& example : examples) {
        if (last == nullptr || *last != example.class_name) {
            html += std::string(last == nullptr ? "" : "</div>\n") + "<h2>" +
                    markup_text(example.class_name) + "</h2>\n<div class=\"examples\">\n";
        }
        last = &example.class_name;
        html +=
            "<table><thead><tr><th scope=\"col\">model</th><th scope=\"col\">by build</th><th "
            "scope=\"col\">by pose</th></tr></thead><tbody><tr>";
        for (const ModelId id : {example.model, example.by_build, example.by_pose}) {
            const auto cell = picture(store, id);
            if (!cell) return cell.error();
            html += *cell;
        }
        html += "</tr></tbody></table>\n";
    }
    if (last != nullptr) html += "</div>\n";
    return html + "</body></html>\n";
}

Result<void> write_pose_gallery(const fs::path& folder, Store& store,
                                std::span<const PoseExample> examples, const std::string& before) {
    const auto html = pose_gallery_html(store, examples, before);
    if (!html) return html.error();
    std::error_code error;
    fs::create_directories(folder, error);
    return write_whole_file(folder / "poses.html", *html);
}

}  // namespace ossuary::index
