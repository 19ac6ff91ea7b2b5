#include "index/prune.h"

#include <algorithm>
#include <functional>

#include "index/model_place.h"

namespace ossuary::index {

namespace fs = std::filesystem;

namespace {

/// The named places that a forgotten mount would make look as they do.
std::vector<fs::path> doubtful_places(const std::vector<fs::path>& roots, const FoundFiles& found) {
    std::vector<fs::path> places = found.broken_links;
    for (const fs::path& root : roots) {
        const bool has_files = std::any_of(
            found.files.begin(), found.files.end(),
            [&](const fs::path& file) { return is_under(place_of(file).file, {root}); });
        if (!has_files) places.push_back(root);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

/// Judges single paths.
class Judge {
public:
    Judge(const std::vector<fs::path>& roots, const FoundFiles& found, const WalkOptions& options)
        : roots_(roots), found_(found), options_(options) {
        for (const UnreadableFolder& each : found.unreadable) unreadable_.push_back(each.path);
    }

    [[nodiscard]] bool goes(const std::string& path) const {
        const ModelPlace place = place_of(path);
        const bool is_named = is_under(place.file, roots_) || is_under(path, roots_);
        if (path.empty() || !is_named || is_found(path) || is_under(place.file, unreadable_)) {
            return false;
        }
        // As if archives were folders.
        const fs::path as_in_folder = place.member.empty() ? place.file : place.file / place.member;
        return is_gone(path) || was_opened(place) || is_whole_now(place) ||
               is_passed_over(as_in_folder, roots_, options_) ||
               is_under(place.file, found_.seen_before);
    }

private:
    static bool is_among(const std::vector<fs::path>& sorted, const fs::path& path) {
        return std::binary_search(
            sorted.begin(), sorted.end(), path,
            [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
    }
    [[nodiscard]] bool is_found(const fs::path& path) const { return is_among(found_.files, path); }
    /// Whether all that is in the file, or the member, has been found.
    [[nodiscard]] bool was_opened(const ModelPlace& place) const {
        return is_among(found_.opened, place.file) ||
               is_among(found_.opened, path_of({place.file, place.member, {}}));
    }
    /// Whether an object's file has been found as one model.
    [[nodiscard]] bool is_whole_now(const ModelPlace& place) const {
        return !place.object.empty() && is_found(path_of({place.file, place.member, {}}));
    }

    const std::vector<fs::path>& roots_;
    const FoundFiles& found_;
    const WalkOptions& options_;
    std::vector<fs::path> unreadable_;
};

}  // namespace

bool is_gone(const fs::path& path) {
    std::error_code error;
    return fs::status(place_of(path).file, error).type() == fs::file_type::not_found;
}

PrunePlan plan_prune(const PruneInput& input, const std::vector<fs::path>& roots,
                     const FoundFiles& found, const WalkOptions& options, bool force) {
    const Judge judge(roots, found, options);
    PrunePlan plan;
    std::vector<const ModelSummary*> models;
    for (const ModelSummary& model : input.models) {
        if (judge.goes(model.path)) models.push_back(&model);
    }
    std::vector<fs::path> spared;
    if (!force) {
        for (const fs::path& place : doubtful_places(roots, found)) {
            const auto lies_there = [&](const std::string& path) {
                return !path.empty() && is_under(place_of(path).file, {place});
            };
            const auto gone = static_cast<std::size_t>(
                std::count_if(models.begin(), models.end(),
                              [&](const ModelSummary* model) { return lies_there(model->path); }));
            const auto all = static_cast<std::size_t>(
                std::count_if(input.paths_before.begin(), input.paths_before.end(), lies_there));
            if (2 * gone <= all) continue;
            plan.refusals.push_back({place, all, gone});
            spared.push_back(place);
        }
    }
    for (const ModelSummary* model : models) {
        if (!is_under(place_of(model->path).file, spared)) plan.models.push_back(model->id);
    }
    for (const Failure& failure : input.failures) {
        if (judge.goes(failure.path) && !is_under(place_of(failure.path).file, spared)) {
            plan.failures.push_back(failure.path);
        }
    }
    return plan;
}

}  // namespace ossuary::index
