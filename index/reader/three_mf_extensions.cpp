#include "index/reader/three_mf_extensions.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <zip.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "index/reader/xml_tag.h"

namespace ossuary::index {
namespace {

struct CloseArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

/// The beginning of a part of the package.
std::string beginning_of(zip_t* archive, zip_uint64_t number) {
    constexpr std::size_t kGlance = 64 << 10;
    const std::unique_ptr<zip_file_t, CloseEntry> entry(zip_fopen_index(archive, number, 0));
    if (!entry) return {};
    std::string text(kGlance, '\0');
    const zip_int64_t got = zip_fread(entry.get(), text.data(), text.size());
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
}

bool is_known(const std::string& extension) {
    BOOL known = 0;
    DWORD version = 0;
    return NMR::lib3mf_queryextensionutf8(extension.c_str(), &known, &version) == LIB3MF_OK &&
           known != 0;
}

}  // namespace

std::vector<std::string> required_extensions(std::string_view model_part) {
    std::vector<std::string> extensions;
    const std::string_view tag = first_tag(model_part, "model");
    std::istringstream prefixes{std::string(xml_attribute(tag, "requiredextensions"))};
    std::string prefix;
    while (prefixes >> prefix) {
        const std::string_view extension = xml_attribute(tag, "xmlns:" + prefix);
        extensions.emplace_back(extension.empty() ? prefix : extension);
    }
    return extensions;
}

Result<void> check_required_extensions(std::string_view package) {
    constexpr zip_int64_t kMostParts = 1000;
    zip_error_t ignored;
    zip_error_init(&ignored);
    zip_source_t* source = zip_source_buffer_create(package.data(), package.size(), 0, &ignored);
    if (source == nullptr) return {};
    const std::unique_ptr<zip_t, CloseArchive> archive(
        zip_open_from_source(source, ZIP_RDONLY, &ignored));
    if (!archive) {
        zip_source_free(source);
        return {};
    }
    const zip_int64_t parts = std::min(zip_get_num_entries(archive.get(), 0), kMostParts);
    for (zip_int64_t i = 0; i < parts; ++i) {
        const auto number = static_cast<zip_uint64_t>(i);
        const char* name = zip_get_name(archive.get(), number, 0);
        if (name == nullptr || !std::string_view(name).ends_with(".model")) continue;
        for (const std::string& extension :
             required_extensions(beginning_of(archive.get(), number))) {
            if (is_known(extension)) continue;
            return {ErrorCode::kThreeMfExtension,
                    "expected extensions that can be read, found " + extension + " required"};
        }
    }
    return {};
}

}  // namespace ossuary::index
