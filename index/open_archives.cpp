#include "index/open_archives.h"

#include <algorithm>

#include "index/model_place.h"

namespace ossuary::index {

namespace fs = std::filesystem;

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
            for (const std::string& model : listed->names) files.push_back(path_of({file, model}));
            found.archives.push_back(std::move(file));
        } else if (!listed->names.empty() ||
                   std::find(roots.begin(), roots.end(), file) != roots.end()) {
            files.push_back(std::move(file));
        } else {
            ++found.passed_over.other_files;
        }
    }
    found.files = std::move(files);
    std::sort(found.files.begin(), found.files.end(),
              [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
    return {};
}

}  // namespace ossuary::index
