#include "index/reader/zip_archive.h"

#include <algorithm>

namespace ossuary::index {
namespace {

struct CloseMember {
    void operator()(zip_file_t* member) const { zip_fclose(member); }
};

Error invalid(const std::string& reason) {
    return {ErrorCode::kArchiveInvalid, "expected a ZIP archive that can be read, found " + reason};
}

Error invalid(zip_error_t& error) {
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    return invalid("one with: " + reason);
}

}  // namespace

Result<ZipArchive> ZipArchive::open(std::string_view bytes) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source == nullptr) return invalid(error);
    zip_t* archive = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (archive == nullptr) {
        zip_source_free(source);
        return invalid(error);
    }
    return ZipArchive(archive);
}

std::uint64_t ZipArchive::size() const {
    return static_cast<std::uint64_t>(
        std::max<zip_int64_t>(zip_get_num_entries(archive_.get(), 0), 0));
}

std::optional<ZipArchive::Member> ZipArchive::member(std::uint64_t number) const {
    zip_stat_t found;
    zip_stat_init(&found);
    if (zip_stat_index(archive_.get(), number, 0, &found) != 0 ||
        (found.valid & ZIP_STAT_NAME) == 0) {
        return {};
    }
    Member member;
    member.name = found.name;
    if ((found.valid & ZIP_STAT_SIZE) != 0) member.size = found.size;
    member.encrypted =
        (found.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && found.encryption_method != ZIP_EM_NONE;
    return member;
}

std::optional<std::uint64_t> ZipArchive::find(const std::string& name) const {
    const zip_int64_t number = zip_name_locate(archive_.get(), name.c_str(), 0);
    if (number < 0) return {};
    return static_cast<std::uint64_t>(number);
}

Result<std::string> ZipArchive::read(std::uint64_t number, std::size_t most) const {
    const std::unique_ptr<zip_file_t, CloseMember> member(
        zip_fopen_index(archive_.get(), number, 0));
    if (!member) return invalid(std::string("one with: ") + zip_strerror(archive_.get()));
    std::string bytes;
    while (bytes.size() < most) {
        // In steps, so that what an archive claims costs nothing before it is there.
        constexpr std::size_t kStep = 1 << 20;
        const std::size_t before = bytes.size();
        bytes.resize(std::min(most, before + kStep));
        const zip_int64_t got =
            zip_fread(member.get(), bytes.data() + before, bytes.size() - before);
        if (got < 0) return invalid(std::string("one with: ") + zip_file_strerror(member.get()));
        bytes.resize(before + static_cast<std::size_t>(got));
        if (got == 0) break;
    }
    return bytes;
}

}  // namespace ossuary::index
