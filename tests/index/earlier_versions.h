#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "index/blob.h"
#include "index/codec.h"

namespace ossuary::test {

/// A blob of an earlier version, sealed as that version's program did.
std::string sealed_as(const index::BlobKind& kind, std::uint8_t version, std::string_view payload);

/// A preview's blob as versions 2 and 3 had it. @pre at most 65,536 vertices
std::string earlier_preview(const index::PreviewMesh& mesh, std::uint8_t version);

/// A descriptor's blob as versions 1 and 2 had it.
std::string earlier_descriptor(const matching::SkeletonDescriptor& descriptor,
                               std::uint8_t version);

}  // namespace ossuary::test
