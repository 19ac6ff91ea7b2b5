#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/voxel/volume.h"

namespace ossuary::voxel {

/// The size of a volume with such sides, each 1 or more. Errors: volume_too_large.
Result<Vec3i> checked_size(const std::array<std::uint64_t, 3>& sides, const VolumeOptions& options);

/// "64 x 64 x 12".
[[nodiscard]] std::string size_text(const Vec3i& size);

/// Whether all numbers are finite and the axes span space.
[[nodiscard]] bool is_usable_frame(const Vec3& origin, const Mat3& axes);

}  // namespace ossuary::voxel
