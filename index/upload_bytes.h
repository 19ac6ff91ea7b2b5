#pragma once

#include <string>
#include <string_view>

#include "index/upload.h"

namespace ossuary::index {

/// What an index keeps of an upload's bytes while it waits: the file as it is, or where something
/// was said of a volume's inside, behind two lines that say so (docs/index-format.md).
[[nodiscard]] std::string stored_bytes(const UploadedModel& upload);

/// Takes them apart into `upload.bytes` and `upload.inside`.
void take_stored_bytes(std::string bytes, UploadedModel& upload);

}  // namespace ossuary::index
