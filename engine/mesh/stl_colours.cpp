#include "engine/mesh/stl_colours.h"

#include <optional>

namespace ossuary::mesh {
namespace {

constexpr std::uint16_t kFlag = 0x8000;

/// Of five bits, so that all of them are the whole of a byte.
std::uint8_t channel_of(std::uint16_t attribute, int lowest_bit) {
    const int value = (attribute >> lowest_bit) & 0x1F;
    return static_cast<std::uint8_t>((value * 255 + 15) / 31);
}

/// What Magics says of the whole model in the header.
std::optional<Colour> model_colour(std::string_view header) {
    constexpr std::string_view kWord = "COLOR=";
    const std::size_t word = header.find(kWord);
    if (word == std::string_view::npos || word + kWord.size() + 4 > header.size()) return {};
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint8_t>(header[word + kWord.size() + i]);
    };
    return Colour{byte(0), byte(1), byte(2)};
}

}  // namespace

std::vector<Colour> stl_colours(std::string_view bytes, std::size_t triangles,
                                std::uint32_t attributes) {
    const std::optional<Colour> model = model_colour(bytes.substr(0, kStlHeader));
    std::vector<Colour> colours;
    if (!model && (attributes & kFlag) == 0) return colours;
    if (model && attributes == 0) {  // no triangle says anything
        colours.assign(triangles, *model);
        return colours;
    }
    colours.reserve(triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
        const std::uint16_t attribute = stl_attribute(bytes, t);
        const bool flagged = (attribute & kFlag) != 0;
        const std::uint8_t low = channel_of(attribute, 0);
        const std::uint8_t middle = channel_of(attribute, 5);
        const std::uint8_t high = channel_of(attribute, 10);
        if (model) {
            colours.push_back(flagged ? *model : Colour{low, middle, high});
        } else {
            colours.push_back(flagged ? Colour{high, middle, low} : kPlainColour);
        }
    }
    return colours;
}

}  // namespace ossuary::mesh
