#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/voxel/volume_surface.h"
#include "index/model.h"

namespace ossuary::index {

/// Counts the uploads that an index has accepted, from 1; never given twice.
using UploadId = std::int64_t;

/// A model that comes as bytes instead of as a file.
struct UploadedModel {
    std::string bytes;
    std::string name;
    std::string class_name;
    voxel::InsideOptions inside = {};  ///< as a person has said of a volume
};

/// How many uploads may wait in an index.
struct UploadLimits {
    std::size_t waiting = 64;
    std::size_t waiting_bytes = 256 << 20;  ///< but one upload may wait whatever its size
};

/// What waits, and is not being worked on.
struct UploadQueue {
    std::size_t waiting = 0;
    std::size_t waiting_bytes = 0;
};

enum class UploadState { kQueued, kRunning, kDone, kFailed };

/// What an index remembers of an upload; of finished ones only the last kRememberedUploads.
struct UploadRecord {
    UploadId id = 0;
    UploadState state = UploadState::kQueued;
    ModelId model = 0;          ///< once done; it may have been removed since
    std::string code, message;  ///< once failed: the stable name of an ErrorCode, and why
    std::string name, class_name;
    std::size_t size = 0;                  ///< bytes
    std::string accepted_at, finished_at;  ///< ISO 8601, UTC; the second empty until it is
};
inline constexpr std::size_t kRememberedUploads = 1000;

/// That an upload is a program's to work on.
struct UploadClaim {
    UploadId id = 0;
    std::string claimant;  ///< see process_mark
};
struct ClaimedUpload {
    UploadClaim claim;
    int attempt = 1;  ///< higher when programs ended in the middle of earlier ones
    UploadedModel model;
};

}  // namespace ossuary::index
