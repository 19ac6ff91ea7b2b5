#include "index/companion_hash.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>

#include "engine/core/whole_file.h"
#include "engine/mesh/obj_materials.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/recognise_format.h"
#include "index/content_hash.h"
#include "index/reader/channel.h"

namespace ossuary::index {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::size_t kMostFiles = 1000;

/// The JSON of a document; empty where it is none.
std::string_view json_of(std::string_view bytes) {
    if (bytes.starts_with("glTF")) {
        constexpr std::size_t kHead = 20;  // the file's and the first chunk's
        if (bytes.size() < kHead) return {};
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 12, sizeof(length));
        return bytes.substr(kHead, length);
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    const bool is_object = first != std::string_view::npos && bytes[first] == '{';
    return is_object ? bytes.substr(first) : std::string_view();
}

int hex_value(std::string_view digits) {
    int value = 0;
    for (const char digit : digits) {
        if (std::isxdigit(static_cast<unsigned char>(digit)) == 0) return -1;
        value = 16 * value + (digit <= '9' ? digit - '0' : (digit | 0x20) - 'a' + 10);
    }
    return value;
}

/// A JSON string's contents as a file's name: escapes of JSON and of URIs undone.
std::string file_name(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escaped = text[i] == '\\' && i + 1 < text.size();
        if (escaped && text[i + 1] == 'u' && i + 6 <= text.size()) {
            const int code = hex_value(text.substr(i + 2, 4));
            plain += code >= 0 && code < 0x80 ? static_cast<char>(code) : '?';
            i += 5;
        } else {
            plain += text[escaped ? ++i : i];
        }
    }
    std::string name;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const int code = plain[i] == '%' && i + 2 < plain.size()
                             ? hex_value(std::string_view(plain).substr(i + 1, 2))
                             : -1;
        name += code >= 0 ? static_cast<char>(code) : plain[i];
        if (code >= 0) i += 2;
    }
    return name;
}

bool is_image(std::string_view name) {
    constexpr std::array<std::string_view, 9> kExtensions = {
        ".png", ".jpg", ".jpeg", ".webp", ".ktx", ".ktx2", ".basis", ".dds", ".gif"};
    std::string lower(name.substr(std::min(name.size(), name.rfind('.'))));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(kExtensions.begin(), kExtensions.end(), lower) != kExtensions.end();
}

/// The string that stands as a value at `at`, behind a colon; where it ends goes into `at`.
std::string_view string_value(std::string_view json, std::size_t& at) {
    const auto skip_blanks = [&] {
        at = std::min(json.find_first_not_of(kBlanks, at), json.size());
    };
    skip_blanks();
    if (at >= json.size() || json[at] != ':') return {};
    ++at;
    skip_blanks();
    if (at >= json.size() || json[at] != '"') return {};
    const std::size_t begin = ++at;
    while (at < json.size() && json[at] != '"') at += json[at] == '\\' ? 2 : 1;
    at = std::min(at, json.size());
    return json.substr(begin, at - begin);
}

/// What stands for a file that cannot be read is no hash.
std::string hash_of(const Result<OwnedDescriptor>& file) {
    if (!file) return "none";
    const auto bytes = read_companion(*file);
    return bytes ? content_hash(bytes->view()) : "none";
}

}  // namespace

Result<WholeFile> read_companion(const OwnedDescriptor& file) {
    struct stat status {};
    if (::fstat(file.get(), &status) == 0) {
        WholeFile bytes(static_cast<std::size_t>(status.st_size));
        if (read_exactly(file.get(), bytes.data(), bytes.size(), 0)) return bytes;
    }
    return {ErrorCode::kFileUnreadable, "expected all of the file, found less"};
}

std::vector<std::string> referred_files(std::string_view bytes) {
    if (mesh::recognise_format(bytes) == mesh::ModelFormat::kObj) {
        return mesh::material_libraries(bytes);
    }
    constexpr std::string_view kKey = "\"uri\"";
    const std::string_view json = json_of(bytes);
    std::vector<std::string> names;
    std::size_t at = json.find(kKey);
    while (at != std::string_view::npos && names.size() < kMostFiles) {
        at += kKey.size();
        const std::string_view value = string_value(json, at);
        if (!value.empty() && !value.starts_with("data:")) {
            std::string name = file_name(value);
            const bool is_new = std::find(names.begin(), names.end(), name) == names.end();
            if (is_new && !is_image(name)) names.push_back(std::move(name));
        }
        at = json.find(kKey, at);
    }
    return names;
}

std::string hash_with_companions(std::string_view bytes, const Companions& companions) {
    std::string hash = content_hash(bytes);
    if (!companions) return hash;
    const std::vector<std::string> names = referred_files(bytes);
    if (names.empty()) return hash;
    for (const std::string& name : names) {
        hash += "\n" + hash_of(companions(name, mesh::ReadMeshOptions{}.max_bytes));
    }
    return content_hash(hash);
}

}  // namespace ossuary::index
