#include "index/upload_bytes.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <system_error>

namespace ossuary::index {
namespace {

constexpr std::string_view kMark = "ossuary-upload 1\n";
constexpr std::string_view kThreshold = "threshold ";
constexpr std::string_view kLabel = "label ";

std::optional<double> number_behind(std::string_view line, std::string_view word) {
    if (!line.starts_with(word)) return {};
    line.remove_prefix(word.size());
    double number = 0.0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error != std::errc{} || end != line.data() + line.size()) return {};
    return number;
}

}  // namespace

std::string stored_bytes(const UploadedModel& upload) {
    const voxel::InsideOptions& inside = upload.inside;
    const bool says_something = inside.threshold || inside.label;
    if (!says_something && !upload.bytes.starts_with(kMark)) return upload.bytes;
    std::string bytes(kMark);
    if (inside.label) {
        bytes += fmt::format("{}{}", kLabel, *inside.label);
    } else if (inside.threshold) {
        bytes += fmt::format("{}{}", kThreshold, *inside.threshold);
    }
    return bytes + "\n" + upload.bytes;
}

void take_stored_bytes(std::string bytes, UploadedModel& upload) {
    upload.bytes = std::move(bytes);
    if (!upload.bytes.starts_with(kMark)) return;
    const std::size_t end = upload.bytes.find('\n', kMark.size());
    if (end == std::string::npos) return;
    const std::string_view line =
        std::string_view(upload.bytes).substr(kMark.size(), end - kMark.size());
    upload.inside = {number_behind(line, kThreshold), number_behind(line, kLabel)};
    upload.bytes.erase(0, end + 1);
}

}  // namespace ossuary::index
