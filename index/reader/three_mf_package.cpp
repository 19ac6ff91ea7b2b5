#include "index/reader/three_mf_package.h"

#include <zip.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "index/reader/xml_tag.h"
#include "index/reader/zip_archive.h"

namespace ossuary::index {
namespace {

/// What a part's relations are kept in, by the part's folder.
constexpr std::string_view kRelations = ".rels";
constexpr std::string_view kRootRelations = "_rels/.rels";

/// The name of a member that a relation of `relations` leads to.
std::string target_of(std::string_view relations, std::string_view target) {
    namespace fs = std::filesystem;
    if (target.starts_with('/')) return std::string(target.substr(1));
    const fs::path folder = fs::path(relations).parent_path().parent_path();
    return (folder / target).lexically_normal().string();
}

/// A document of relations without those that do not matter; counts them.
std::string without_others(const ZipArchive& archive, std::string_view name,
                           std::string_view document, std::size_t& dropped) {
    constexpr std::string_view kTag = "<Relationship";
    std::string kept;
    std::size_t from = 0;
    for (std::size_t at = document.find(kTag); at != std::string_view::npos;
         at = document.find(kTag, std::max(at + 1, from))) {
        const std::size_t end = document.find('>', at);
        if (end == std::string_view::npos) break;
        const std::string_view tag = document.substr(at, end - at + 1);
        if (tag.starts_with("<Relationships") || !tag.ends_with("/>")) continue;
        const std::string_view type = xml_attribute(tag, "Type");
        const std::string_view target = xml_attribute(tag, "Target");
        const bool may_matter = name != kRootRelations && !type.ends_with("/printticket") &&
                                archive.find(target_of(name, target)).has_value();
        if (type.ends_with("/3dmodel") || may_matter) continue;
        kept += document.substr(from, at - from);
        from = end + 1;
        ++dropped;
    }
    kept += document.substr(from);
    return kept;
}

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Source = std::unique_ptr<zip_source_t, FreeSource>;

struct Replacement {
    std::uint64_t number = 0;
    std::string document;
};

std::optional<std::string> all_of(zip_source_t* source) {
    zip_stat_t found;
    zip_stat_init(&found);
    if (zip_source_stat(source, &found) != 0 || (found.valid & ZIP_STAT_SIZE) == 0 ||
        zip_source_open(source) != 0) {
        return {};
    }
    std::string bytes(found.size, '\0');
    const zip_int64_t got = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (got < 0 || static_cast<std::uint64_t>(got) != found.size) return {};
    return bytes;
}

/// The archive with some of its members replaced. Written anew: changed in place, libzip 1.7.3
/// frees memory twice where what comes first stays as it is.
std::optional<std::string> rewritten(std::string_view package,
                                     const std::vector<Replacement>& replacements) {
    zip_source_t* old_bytes = zip_source_buffer_create(package.data(), package.size(), 0, nullptr);
    const Source new_bytes(zip_source_buffer_create(nullptr, 0, 0, nullptr));
    if (old_bytes == nullptr || !new_bytes) return {};
    const Archive from(zip_open_from_source(old_bytes, ZIP_RDONLY, nullptr));
    if (!from) {
        zip_source_free(old_bytes);
        return {};
    }
    zip_source_keep(new_bytes.get());  // beside the archive, which frees what it was given
    Archive to(zip_open_from_source(new_bytes.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr));
    if (!to) {
        zip_source_free(new_bytes.get());
        return {};
    }
    const auto members = static_cast<std::uint64_t>(zip_get_num_entries(from.get(), 0));
    for (std::uint64_t i = 0; i < members; ++i) {
        const auto replacement = std::find_if(replacements.begin(), replacements.end(),
                                              [i](const Replacement& r) { return r.number == i; });
        const char* name = zip_get_name(from.get(), i, 0);
        zip_source_t* member =
            replacement == replacements.end()
                ? zip_source_zip(to.get(), from.get(), i, ZIP_FL_COMPRESSED, 0, -1)
                : zip_source_buffer(to.get(), replacement->document.data(),
                                    replacement->document.size(), 0);
        if (member == nullptr || name == nullptr) return {};
        if (zip_file_add(to.get(), name, member, ZIP_FL_ENC_UTF_8) < 0) {
            zip_source_free(member);
            return {};
        }
    }
    if (zip_close(to.get()) != 0) return {};
    static_cast<void>(to.release());  // closed
    return all_of(new_bytes.get());
}

}  // namespace

std::optional<TrimmedPackage> trim_package(std::string_view package) {
    constexpr std::uint64_t kMostParts = 10'000;
    constexpr std::size_t kMostRelations = 4 << 20;  // bytes
    const auto archive = ZipArchive::open(package);
    if (!archive) return {};
    TrimmedPackage trimmed;
    std::vector<Replacement> replacements;
    for (std::uint64_t i = 0; i < std::min(archive->size(), kMostParts); ++i) {
        const auto part = archive->member(i);
        if (!part || !part->name.ends_with(kRelations)) continue;
        const auto document = archive->read(i, kMostRelations);
        if (!document || document->size() == kMostRelations) return {};
        const std::size_t before = trimmed.dropped;
        std::string kept = without_others(*archive, part->name, *document, trimmed.dropped);
        if (trimmed.dropped > before) replacements.push_back({i, std::move(kept)});
    }
    if (trimmed.dropped == 0) return {};
    auto bytes = rewritten(package, replacements);
    if (!bytes) return {};
    trimmed.bytes = *std::move(bytes);
    return trimmed;
}

}  // namespace ossuary::index
