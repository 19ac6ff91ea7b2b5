#include "engine/decomposition/seg_file.h"

#include <algorithm>
#include <charconv>

#include "engine/core/whole_file.h"

namespace ossuary::decomposition {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

Error invalid(std::string_view name, const std::string& what) {
    return {ErrorCode::kSegInvalid, std::string(name) + ": " + what};
}

}  // namespace

Result<Segmentation> parse_seg(std::string_view text, std::string_view name, std::size_t faces) {
    std::vector<std::uint32_t> labels;
    labels.reserve(faces);
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t line = 1;; ++line) {
        while (at != end && is_space(*at)) line += *at++ == '\n' ? 1 : 0;
        if (at == end) break;
        std::uint32_t label = 0;
        const auto [after, failure] = std::from_chars(at, end, label);
        if (failure != std::errc{} || (after != end && !is_space(*after))) {
            return invalid(name, "line " + std::to_string(line) +
                                     ": expected a label, a number from 0 to 4294967295");
        }
        labels.push_back(label);
        if (labels.size() > faces) break;
        at = after;
        --line;
    }
    if (labels.size() != faces) {
        const std::string found =
            labels.size() > faces ? "more" : std::to_string(labels.size()) + " labels";
        return invalid(name, "expected a label for each of " + std::to_string(faces) +
                                 " faces, found " + found);
    }
    return dense_segmentation(labels);
}

Result<Segmentation> read_seg(const std::filesystem::path& path, std::size_t faces) {
    const Result<WholeFile> file = read_whole_file(path);
    if (!file) return file.error();
    return parse_seg(file->view(), path.filename().string(), faces);
}

std::string to_seg(const Segmentation& segmentation) {
    std::string text;
    for (const std::uint32_t label : segmentation.labels) text += std::to_string(label) + "\n";
    return text;
}

Result<std::vector<Segmentation>> read_segmentations(const std::filesystem::path& folder,
                                                     const std::string& model, std::size_t faces) {
    std::vector<std::filesystem::path> paths;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder / model, ignored)) {
        if (entry.path().extension() == ".seg") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Segmentation> segmentations;
    for (const std::filesystem::path& path : paths) {
        Result<Segmentation> segmentation = read_seg(path, faces);
        if (!segmentation) return segmentation.error();
        segmentations.push_back(*std::move(segmentation));
    }
    return segmentations;
}

}  // namespace ossuary::decomposition
