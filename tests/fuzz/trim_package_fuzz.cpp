// Feeds 3MF packages with arbitrary relations to what leaves some of them out: those of the root up
// to a length in the first byte, then those of a part.

#include <zip.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "index/reader/three_mf_package.h"
#include "index/reader/zip_archive.h"
#include "tests/fuzz/require.h"

namespace {

using namespace ossuary;
using Members = std::array<std::pair<const char*, std::string_view>, 3>;

std::string zipped(const Members& members) {
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    fuzz::require(target != nullptr);
    zip_source_keep(target);
    zip_t* archive = zip_open_from_source(target, ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    fuzz::require(archive != nullptr);
    for (const auto& [name, bytes] : members) {
        zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
        const auto added = zip_file_add(archive, name, source, ZIP_FL_ENC_UTF_8);
        fuzz::require(added >= 0);
        zip_set_file_compression(archive, static_cast<zip_uint64_t>(added), ZIP_CM_STORE, 0);
    }
    fuzz::require(zip_close(archive) == 0);
    zip_stat_t found;
    zip_stat_init(&found);
    fuzz::require(zip_source_stat(target, &found) == 0 && zip_source_open(target) == 0);
    std::string bytes(found.size, '\0');
    fuzz::require(zip_source_read(target, bytes.data(), bytes.size()) ==
                  static_cast<zip_int64_t>(bytes.size()));
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    const std::string_view root = bytes.substr(0, 8 * std::size_t{data[0]});
    const Members members = {{{"_rels/.rels", root},
                              {"3D/a.model", "<model/>"},
                              {"3D/_rels/a.model.rels", bytes.substr(root.size())}}};
    // Bytes that are no archive, too.
    static_cast<void>(index::trim_package(bytes));
    const auto trimmed = index::trim_package(zipped(members));
    if (!trimmed) return 0;
    fuzz::require(trimmed->dropped > 0);
    const auto archive = index::ZipArchive::open(trimmed->bytes);
    fuzz::require(archive.ok() && archive->size() == members.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto member = archive->member(i);
        fuzz::require(member && member->name == members[i].first);
        const auto kept = archive->read(i, 1 << 20);
        fuzz::require(kept.ok() && kept->size() <= members[i].second.size());
    }
    return 0;
}
