#include "index/model_place.h"

#include <string_view>
#include <utility>

#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

namespace fs = std::filesystem;

namespace {

/// A path parted at the first `#` that follows a model file's name and has something after it.
std::pair<std::string_view, std::string_view> part(std::string_view path) {
    for (std::size_t mark = path.find('#'); mark != std::string_view::npos;
         mark = path.find('#', mark + 1)) {
        const std::string_view file = path.substr(0, mark), within = path.substr(mark + 1);
        if (!within.empty() && mesh::is_model_file(file)) return {file, within};
    }
    return {path, {}};
}

}  // namespace

fs::path ModelPlace::file_name() const {
    return member.empty() ? file.filename() : fs::path(member).filename();
}

std::string ModelPlace::name() const {
    return object.empty() ? file_name().stem().string() : object;
}

ModelPlace place_of(const fs::path& path) {
    std::error_code error;
    const std::string& text = path.native();
    if (text.find('#') == std::string::npos || fs::exists(fs::status(path, error))) {
        return {path, "", ""};
    }
    const auto [file, within] = part(text);
    if (!is_archive_name(file)) return {file, "", std::string(within)};
    const auto [member, object] = part(within);
    return {file, std::string(member), std::string(object)};
}

fs::path path_of(const ModelPlace& place) {
    std::string path = place.file.native();
    for (const std::string& within : {place.member, place.object}) {
        if (!within.empty()) path += "#" + within;
    }
    return path;
}

bool is_archive_name(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return extension == ".zip";
}

}  // namespace ossuary::index
