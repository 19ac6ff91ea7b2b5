#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"

namespace ossuary::index {

/// A picture of width * height pixels with `channels` bytes each (3 = RGB, 4 = RGBA, not
/// premultiplied, sRGB), rows from the top, as a PNG file. Errors: internal.
Result<std::vector<std::uint8_t>> png_bytes(std::span<const std::uint8_t> pixels, int width,
                                            int height, int channels);

}  // namespace ossuary::index
