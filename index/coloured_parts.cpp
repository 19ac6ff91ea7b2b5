#include "index/coloured_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ossuary::index {
mesh::Colour part_colour(std::uint32_t part) {
    constexpr double kGoldenTurn = 0.61803398874989485;
    constexpr double kSaturation = 0.55, kValue = 0.92;
    const double hue = std::fmod(0.58 + kGoldenTurn * part, 1.0);
    mesh::Colour colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // The usual trapezoids of the HSV model, a third of a turn apart.
        const double shifted =
            std::fmod(6.0 * hue + 4.0 * (3.0 - static_cast<double>(channel)), 6.0);
        const double trapezoid = std::clamp(std::abs(shifted - 3.0) - 1.0, 0.0, 1.0);
        const double value = kValue * (1.0 - kSaturation * (1.0 - trapezoid));
        colour[channel] = static_cast<std::uint8_t>(std::lround(255.0 * value));
    }
    return colour;
}

std::vector<mesh::Colour> part_colours(const decomposition::Segmentation& segmentation) {
    std::vector<mesh::Colour> colours;
    colours.reserve(segmentation.labels.size());
    for (const std::uint32_t part : segmentation.labels) colours.push_back(part_colour(part));
    return colours;
}

}  // namespace ossuary::index
