#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace ossuary::index {

/// The kinds of blob in an index, each with its four-letter mark and the version it is written in.
/// All earlier versions are read too.
struct BlobKind {
    std::string_view mark;  ///< four ASCII letters
    std::uint8_t version = 1;
};

inline constexpr BlobKind kSkeletonBlob{"SKEL", 2};
inline constexpr BlobKind kDescriptorBlob{"DESC", 3};
inline constexpr BlobKind kGlobalsBlob{"GLOB", 3};
inline constexpr BlobKind kSignatureBlob{"SIGN", 1};
inline constexpr BlobKind kPreviewBlob{"MESH", 4};
inline constexpr BlobKind kSegmentsBlob{"PART", 2};
inline constexpr BlobKind kFeaturesBlob{"FEAT", 1};
inline constexpr BlobKind kThumbnailBlob{"THUM", 1};
inline constexpr BlobKind kStatisticsBlob{"STAT", 1};
inline constexpr BlobKind kEvaluationBlob{"EVAL", 1};
inline constexpr BlobKind kScanBlob{"SCAN", 1};

/// Every blob: mark (4), version (1), zeros (3), payload, XXH3-64 of all before it (8).
inline constexpr std::size_t kBlobHeaderSize = 8;
inline constexpr std::size_t kBlobTrailerSize = 8;

[[nodiscard]] std::string seal_blob(const BlobKind& kind, std::string_view payload);

/// The payload of a blob of this kind, a view into `blob`.
/// Errors: index_corrupt (too short, another kind, checksum), index_newer (a later version).
Result<std::string_view> open_blob(const BlobKind& kind, std::string_view blob);

/// The version that an opened blob was written in, from 1 to its kind's.
/// @pre open_blob has accepted it
[[nodiscard]] std::uint8_t blob_version(std::string_view blob);

/// index_corrupt, with the blob's mark and what is wrong with it.
[[nodiscard]] Error corrupt_blob(const BlobKind& kind, std::string_view what);

}  // namespace ossuary::index
