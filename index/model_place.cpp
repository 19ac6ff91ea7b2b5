#include "index/model_place.h"

#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

namespace fs = std::filesystem;

fs::path ModelPlace::file_name() const {
    return within.empty() ? file.filename() : fs::path(within).filename();
}

ModelPlace place_of(const fs::path& path) {
    std::error_code error;
    const std::string& text = path.native();
    std::size_t mark = text.find('#');
    if (mark == std::string::npos || fs::exists(fs::status(path, error))) return {path, ""};
    for (; mark != std::string::npos; mark = text.find('#', mark + 1)) {
        const fs::path file = text.substr(0, mark);
        if (mark + 1 < text.size() && mesh::is_model_file(file)) {
            return {file, text.substr(mark + 1)};
        }
    }
    return {path, ""};
}

fs::path path_of(const ModelPlace& place) {
    if (place.within.empty()) return place.file;
    return place.file.native() + "#" + place.within;
}

}  // namespace ossuary::index
