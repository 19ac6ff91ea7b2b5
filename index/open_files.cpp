#include "index/open_files.h"

#include <algorithm>

#include "engine/core/parallel.h"
#include "index/model_place.h"

namespace ossuary::index {

namespace fs = std::filesystem;

namespace {

void sort_by_bytes(std::vector<fs::path>& paths) {
    std::sort(paths.begin(), paths.end(),
              [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
}

}  // namespace

Result<void> open_archives(FoundFiles& found, const std::vector<fs::path>& roots,
                           const WalkOptions& options, ModelReader& reader,
                           const std::stop_token& stop) {
    std::vector<fs::path> files;
    for (fs::path& file : found.files) {
        if (stop.stop_requested()) {
            return {ErrorCode::kCancelled, "looking for models was stopped"};
        }
        if (!is_archive_name(file)) {
            files.push_back(std::move(file));
            continue;
        }
        auto listed = reader.list_archive(file, stop);
        if (!listed || listed->is_package) {
            files.push_back(std::move(file));
            continue;
        }
        const bool several = listed->names.size() > 1;
        std::erase_if(listed->names, [&](const std::string& model) {
            const bool passed_over = is_passed_over(file / model, roots, options);
            if (passed_over) ++found.passed_over.excluded;
            return passed_over;
        });
        if (several) {
            for (const std::string& model : listed->names)
                files.push_back(path_of({file, model, {}}));
            found.opened.push_back(std::move(file));
        } else if (!listed->names.empty() ||
                   std::find(roots.begin(), roots.end(), file) != roots.end()) {
            files.push_back(std::move(file));
        } else {
            ++found.passed_over.other_files;
        }
    }
    found.files = std::move(files);
    sort_by_bytes(found.files);
    return {};
}

Result<void> split_files(FoundFiles& found, ModelReader& reader, int jobs,
                         const std::stop_token& stop) {
    std::vector<std::vector<std::string>> objects(found.files.size());
    parallel_for(found.files.size(), jobs, [&](std::size_t i) {
        if (stop.stop_requested() || !place_of(found.files[i]).object.empty()) return;
        auto names = reader.list_objects(found.files[i], {}, stop);
        if (names) objects[i] = *std::move(names);
    });
    if (stop.stop_requested()) return {ErrorCode::kCancelled, "looking for models was stopped"};
    std::vector<fs::path> files;
    for (std::size_t i = 0; i < found.files.size(); ++i) {
        fs::path& file = found.files[i];
        if (objects[i].size() < 2) {
            files.push_back(std::move(file));
            continue;
        }
        ModelPlace place = place_of(file);
        for (std::string& object : objects[i]) {
            place.object = std::move(object);
            files.push_back(path_of(place));
        }
        found.opened.push_back(std::move(file));
    }
    found.files = std::move(files);
    sort_by_bytes(found.files);
    sort_by_bytes(found.opened);
    return {};
}

}  // namespace ossuary::index
