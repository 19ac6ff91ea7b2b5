#include "engine/descriptor/view_spectra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/descriptor/image_spectrum.h"
#include "engine/descriptor/view_images.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

std::vector<float> random_image(std::size_t pixels, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<float> image;
    for (std::size_t i = 0; i < pixels; ++i)
        image.push_back(static_cast<float>(test::next_unit(random)));
    return image;
}

TEST(ImageSpectrum, DoesNotKnowShiftsAndMirrors) {
    constexpr std::size_t kRows = 16, kColumns = 32;
    const ImageSpectrum spectrum({kRows, kColumns}, {4, 6});
    const std::vector<float> image = random_image(kRows * kColumns, 5);
    std::vector<float> shifted(image.size()), mirrored(image.size());
    for (std::size_t y = 0; y < kRows; ++y) {
        for (std::size_t x = 0; x < kColumns; ++x) {
            const float value = image[y * kColumns + x];
            shifted[((y + 3) % kRows) * kColumns + (x + 11) % kColumns] = value;
            mirrored[y * kColumns + kColumns - 1 - x] = value;
        }
    }
    const auto expected = spectrum.magnitudes(image);
    ASSERT_EQ(expected.size(), 24U);
    for (const auto& changed : {shifted, mirrored}) {
        const auto found = spectrum.magnitudes(changed);
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-5);
    }
}

TEST(ImageSpectrum, FindsTheFrequencyOfAWave) {
    constexpr std::size_t kSide = 32;
    std::vector<float> image;
    for (std::size_t y = 0; y < kSide; ++y) {
        for (std::size_t x = 0; x < kSide; ++x) {
            const double phase =
                2.0 * std::numbers::pi * static_cast<double>(3 * x + 2 * y) / kSide;
            image.push_back(static_cast<float>(std::cos(phase)));
        }
    }
    const auto found = ImageSpectrum({kSide, kSide}, {8, 8}).magnitudes(image);
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i], i == 2 * 8 + 3 ? 0.25F : 0.0F, 1e-5) << i;
    }
}

TEST(Panorama, OfABallIsOneRadiusWhereverItFaces) {
    const SolidSurface surface = solid_surface(test::ball(20.0).volume);
    const PrincipalFrame frame = principal_frame(surface, FrameKind::kPositions);
    const ViewImage image = panorama(surface, frame, 2);
    // The belt about the middle is at the ball's radius, a third of the cylinder's.
    for (std::size_t column = 0; column < image.columns; ++column) {
        const std::size_t pixel = image.rows / 2 * image.columns + column;
        EXPECT_NEAR(image.extent[pixel], 1.0 / 3.0, 0.03) << column;
        EXPECT_GT(image.facing[pixel], 0.9F) << column;
    }
    EXPECT_EQ(image.extent.front(), 0.0F);
}

TEST(Panorama, HasNoGapsOnAnElongatedBody) {
    const SolidSurface surface = solid_surface(test::bar({12, 16, 100}).volume);
    const PrincipalFrame frame = principal_frame(surface, FrameKind::kPositions);
    const ViewImage image = panorama(surface, frame, 0);
    for (std::size_t row = 25; row < 40; ++row) {
        for (std::size_t column = 0; column < image.columns; ++column) {
            ASSERT_GT(image.extent[row * image.columns + column], 0.0F) << row << " " << column;
        }
    }
}

TEST(ViewDistance, DoesNotKnowTheOrderAndTheSignsOfAxes) {
    const voxel::BitVolume volume = test::capsule_tree().volume;
    const auto original = view_spectra(solid_surface(volume));
    const auto other = view_spectra(solid_surface(test::torus().volume));
    const double far = view_distance(original, other);
    for (const Vec3i& order : {Vec3i(1, 2, 0), Vec3i(0, 2, 1), Vec3i(2, 1, 0)}) {
        const auto turned = view_spectra(solid_surface(test::permuted(volume, order)));
        EXPECT_LT(view_distance(original, turned), 0.1 * far);
    }
    const auto mirrored = view_spectra(solid_surface(test::mirrored(volume, 1)));
    EXPECT_LT(view_distance(original, mirrored), 0.1 * far);
    EXPECT_EQ(view_distance(original, original), 0.0);
    EXPECT_EQ(view_distance(original, other), view_distance(other, original));
}

TEST(ViewDistance, LetsAxesChangePlaces) {
    const auto spectra = view_spectra(solid_surface(test::capsule_tree().volume));
    // The same views numbered in another order, their images' axes exchanged where that mirrors.
    const auto reordered = [&](const std::array<std::size_t, 3>& order, bool exchange) {
        std::vector<std::uint8_t> result(spectra.size());
        for (std::size_t frame = 0; frame < kViewFrames; ++frame) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint8_t* from = spectra.data() + (frame * 3 + order[axis]) * kViewSize;
                std::uint8_t* to = result.data() + (frame * 3 + axis) * kViewSize;
                std::copy_n(from, kViewSize, to);
                if (!exchange) continue;
                for (std::size_t i = 0; i < 4 * kDepthSpectrum; ++i) {
                    const std::size_t part = i / kDepthSpectrum, cell = i % kDepthSpectrum;
                    to[2 * kPanoramaSpectrum + i] =
                        from[2 * kPanoramaSpectrum + part * kDepthSpectrum +
                             cell % kDepthFrequencies * kDepthFrequencies +
                             cell / kDepthFrequencies];
                }
            }
        }
        return result;
    };
    EXPECT_EQ(view_distance(spectra, reordered({1, 2, 0}, false)), 0.0);
    EXPECT_EQ(view_distance(spectra, reordered({2, 0, 1}, false)), 0.0);
    EXPECT_EQ(view_distance(spectra, reordered({1, 0, 2}, true)), 0.0);
    EXPECT_EQ(view_distance(spectra, reordered({0, 2, 1}, true)), 0.0);
    EXPECT_EQ(view_distance(spectra, reordered({2, 1, 0}, true)), 0.0);
    EXPECT_GT(view_distance(spectra, reordered({2, 1, 0}, false)), 0.0);
}

}  // namespace
}  // namespace ossuary::descriptor
