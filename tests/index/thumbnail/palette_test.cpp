#include "index/thumbnail/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace ossuary::index {
namespace {

using Pixels = std::vector<std::uint8_t>;

PalettePicture::Colour pixel(const Pixels& rgba, std::size_t i) {
    return {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2], rgba[4 * i + 3]};
}

/// The greatest difference of a channel between a picture and its palette's.
int greatest_error(const Pixels& rgba, const PalettePicture& picture, bool opaque) {
    int greatest = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const auto before = pixel(rgba, i);
        const auto after = picture.colours[picture.pixels[i]];
        if (before[3] == 0 || (before[3] == 255) != opaque) continue;
        for (std::size_t c = 0; c < 4; ++c) {
            greatest = std::max(greatest, std::abs(int{before[c]} - int{after[c]}));
        }
    }
    return greatest;
}

TEST(Palette, KeepsFewColoursAsTheyAre) {
    Pixels rgba;
    for (int i = 0; i < 200; ++i) {
        rgba.insert(rgba.end(), {std::uint8_t(i), std::uint8_t(255 - i), 7, std::uint8_t(i)});
    }
    const auto picture = reduce_colours(rgba);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->pixels.size(), 200u);
    EXPECT_EQ(greatest_error(rgba, *picture, true), 0);
    EXPECT_EQ(greatest_error(rgba, *picture, false), 0);
    // What cannot be seen is one colour, whatever it was.
    EXPECT_EQ(picture->colours[picture->pixels[0]], (PalettePicture::Colour{0, 0, 0, 0}));
}

/// All shades of one colour, opaque and at an outline.
Pixels shaded_surface() {
    Pixels rgba;
    for (int shade = 0; shade < 256; ++shade) {
        for (const int alpha : {0, 20, 90, 160, 230, 255}) {
            for (const int part : {214, 204, 184}) {
                rgba.push_back(static_cast<std::uint8_t>(part * shade / 255));
            }
            rgba.push_back(static_cast<std::uint8_t>(alpha));
        }
    }
    return rgba;
}

TEST(Palette, StandsForAShadedSurfaceWithoutADifferenceThatIsSeen) {
    const Pixels rgba = shaded_surface();
    const auto picture = reduce_colours(rgba);
    ASSERT_TRUE(picture);
    EXPECT_LE(picture->colours.size(), 256u);
    EXPECT_LE(greatest_error(rgba, *picture, true), 3);
    EXPECT_LE(greatest_error(rgba, *picture, false), 31);
    EXPECT_EQ(reduce_colours(rgba)->pixels, picture->pixels);
}

TEST(Palette, GivesUpWhereColoursAreTooMany) {
    Pixels rgba;
    for (int red = 0; red < 256; red += 16) {
        for (int green = 0; green < 256; green += 16) {
            for (int blue = 0; blue < 256; blue += 64) {
                rgba.insert(rgba.end(),
                            {std::uint8_t(red), std::uint8_t(green), std::uint8_t(blue), 255});
            }
        }
    }
    EXPECT_FALSE(reduce_colours(rgba));
    EXPECT_TRUE(reduce_colours({})->pixels.empty());
}

}  // namespace
}  // namespace ossuary::index
