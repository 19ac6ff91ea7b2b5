#include "index/reader/three_mf_extensions.h"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <algorithm>
#include <sstream>

#include "index/reader/xml_tag.h"
#include "index/reader/zip_archive.h"

namespace ossuary::index {
namespace {

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
    constexpr std::uint64_t kMostParts = 1000;
    constexpr std::size_t kGlance = 64 << 10;
    const auto archive = ZipArchive::open(package);
    if (!archive) return {};  // the library says what is wrong with it
    for (std::uint64_t i = 0; i < std::min(archive->size(), kMostParts); ++i) {
        const auto part = archive->member(i);
        if (!part || !part->name.ends_with(".model")) continue;
        const auto beginning = archive->read(i, kGlance);
        if (!beginning) continue;
        for (const std::string& extension : required_extensions(*beginning)) {
            if (is_known(extension)) continue;
            return {ErrorCode::kThreeMfExtension,
                    "expected extensions that can be read, found " + extension + " required"};
        }
    }
    return {};
}

}  // namespace ossuary::index
