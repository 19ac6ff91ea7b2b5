#pragma once

#include <string_view>

namespace ossuary::voxel {

/// Whether bytes begin with a header of NIfTI, version 1 or 2.
[[nodiscard]] bool looks_like_nifti(std::string_view bytes);

}  // namespace ossuary::voxel
