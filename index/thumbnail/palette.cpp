#include "index/thumbnail/palette.h"

#include <cstddef>
#include <map>

namespace ossuary::index {

namespace {

/// How many leading bits of a byte count when colours are told apart.
struct Precision {
    int opaque;  ///< of the colour of a pixel that is opaque
    int border;  ///< of the colour of one that is partly transparent
    int alpha;   ///< of its transparency
};
constexpr std::array kPrecisions = {Precision{8, 8, 8}, Precision{7, 5, 4}, Precision{6, 4, 3},
                                    Precision{6, 3, 3}};

constexpr std::size_t kMostColours = 256;
constexpr std::size_t kChannels = 4;

/// Colours with one key become one.
std::uint32_t key_of(std::span<const std::uint8_t> pixel, const Precision& precision) {
    const std::uint8_t alpha = pixel[3];
    if (alpha == 0) return 0;
    const bool opaque = alpha == 255;
    const int colour_shift = 8 - (opaque ? precision.opaque : precision.border);
    // Never 0, and never that of the opaque pixels.
    const int alpha_shift = 8 - precision.alpha;
    std::uint32_t key = opaque ? 0x1FFU : 1U + static_cast<std::uint32_t>(alpha >> alpha_shift);
    for (std::size_t c = 0; c < 3; ++c) {
        key = key * 256U + static_cast<std::uint32_t>(pixel[c] >> colour_shift);
    }
    return key;
}

/// The mean of the colours that share a key.
struct Mean {
    std::array<std::uint64_t, kChannels> sums{};
    std::uint64_t count = 0;
    std::uint8_t index = 0;

    void add(std::span<const std::uint8_t> pixel) {
        for (std::size_t c = 0; c < kChannels; ++c) sums[c] += pixel[c];
        ++count;
    }
    [[nodiscard]] PalettePicture::Colour colour() const {
        PalettePicture::Colour colour{};
        for (std::size_t c = 0; c < kChannels; ++c) {
            colour[c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
        }
        return colour;
    }
};

std::optional<PalettePicture> reduce(std::span<const std::uint8_t> rgba,
                                     const Precision& precision) {
    std::map<std::uint32_t, Mean> means;
    for (std::size_t i = 0; i + kChannels <= rgba.size(); i += kChannels) {
        const auto pixel = rgba.subspan(i, kChannels);
        means[key_of(pixel, precision)].add(pixel);
        if (means.size() > kMostColours) return std::nullopt;
    }
    PalettePicture picture;
    for (auto& [key, mean] : means) {
        mean.index = static_cast<std::uint8_t>(picture.colours.size());
        // What cannot be seen has no colour.
        picture.colours.push_back(key == 0 ? PalettePicture::Colour{} : mean.colour());
    }
    picture.pixels.reserve(rgba.size() / kChannels);
    for (std::size_t i = 0; i + kChannels <= rgba.size(); i += kChannels) {
        picture.pixels.push_back(means[key_of(rgba.subspan(i, kChannels), precision)].index);
    }
    return picture;
}

}  // namespace

std::optional<PalettePicture> reduce_colours(std::span<const std::uint8_t> rgba) {
    for (const Precision& precision : kPrecisions) {
        if (auto picture = reduce(rgba, precision)) return picture;
    }
    return std::nullopt;
}

}  // namespace ossuary::index
