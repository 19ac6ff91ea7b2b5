#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ossuary::index {

/// A picture of at most 256 colours: which of them each pixel has.
struct PalettePicture {
    using Colour = std::array<std::uint8_t, 4>;  ///< red, green, blue, alpha; sRGB
    std::vector<Colour> colours;
    std::vector<std::uint8_t> pixels;
};

/// A picture with so few colours that no eye tells it from `rgba`: shades of one colour are at most
/// three of 255 away where the picture is opaque, where that is not fully so at most 31. None where
/// 256 colours are too few, as for a model of many colours. A shaded surface of one colour has
/// about 600, most of them on its outlines. The same pixels give the same palette.
/// @param rgba  four bytes a pixel
[[nodiscard]] std::optional<PalettePicture> reduce_colours(std::span<const std::uint8_t> rgba);

}  // namespace ossuary::index
