#include "index/reader/read_archive.h"

#include <unordered_set>

#include "engine/mesh/text_scanner.h"
#include "index/reader/zip_archive.h"

namespace ossuary::index {

Result<std::vector<ArchiveMember>> list_archive(std::string_view bytes) {
    const auto archive = ZipArchive::open(bytes);
    if (!archive) return archive.error();
    if (archive->size() > kMostMembers) {
        return {ErrorCode::kArchiveInvalid, "expected at most " + std::to_string(kMostMembers) +
                                                " members, found " +
                                                std::to_string(archive->size())};
    }
    std::vector<ArchiveMember> members;
    std::unordered_set<std::string> seen;
    for (std::uint64_t i = 0; i < archive->size(); ++i) {
        const auto member = archive->member(i);
        const bool is_file = member && !member->name.empty() && !member->name.ends_with('/');
        if (!is_file || member->name.size() > kLongestMember || !seen.insert(member->name).second) {
            continue;
        }
        members.push_back({member->name, member->size});
    }
    return members;
}

Result<std::string> unpack_member(std::string_view bytes, const UnpackRequest& request) {
    const auto archive = ZipArchive::open(bytes);
    if (!archive) return archive.error();
    const auto number = archive->find(request.member);
    const auto member = number ? archive->member(*number) : std::nullopt;
    if (!member) {
        return {ErrorCode::kArchiveMember, "expected a member " +
                                               mesh::quoted_token(request.member) +
                                               " in the archive, found none of that name"};
    }
    if (member->encrypted) {
        return {ErrorCode::kArchiveInvalid,
                "expected members that anyone can read, found one with a password"};
    }
    // One byte more than there may be: what is longer is seen, and the end with its checksum read.
    auto unpacked = archive->read(*number, request.max_bytes + 1);
    if (unpacked && unpacked->size() > request.max_bytes) {
        return {ErrorCode::kFileTooLarge, "expected at most " + std::to_string(request.max_bytes) +
                                              " bytes unpacked, found more"};
    }
    return unpacked;
}

}  // namespace ossuary::index
