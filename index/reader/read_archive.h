#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "index/reader/protocol.h"

namespace ossuary::index {

/// The files in a ZIP archive, in its order; the first of each name, without folders, and without
/// names that nothing could ask for. Errors: archive_invalid (more members than kMostMembers, too).
Result<std::vector<ArchiveMember>> list_archive(std::string_view archive);
inline constexpr std::uint64_t kMostMembers = 1'000'000;

/// One of them. Errors: archive_invalid (encrypted ones too), archive_member (there is none of that
/// name), file_too_large.
Result<std::string> unpack_member(std::string_view archive, const UnpackRequest& request);

}  // namespace ossuary::index
