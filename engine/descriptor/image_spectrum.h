#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace ossuary::descriptor {

/// Magnitudes of the low frequencies of images of one size. They do not change when an image is
/// shifted around, nor, because mirrored frequencies are averaged, when it is mirrored.
class ImageSpectrum {
public:
    struct Size {
        std::size_t rows = 0;
        std::size_t columns = 0;
    };
    /// @param kept  frequencies kept: from 0 on, below half the image's size
    ImageSpectrum(const Size& image, const Size& kept);

    /// (|F(k, l)| + |F(k, -l)|) / 2 over the number of pixels, in the order of l (down the rows),
    /// then k (along them).
    /// @param pixels  row by row
    [[nodiscard]] std::vector<float> magnitudes(std::span<const float> pixels) const;

private:
    Size image_, kept_;
    /// exp(-2 pi i k x / columns), real and imaginary parts apart; exp(-2 pi i l y / rows).
    std::vector<float> along_real_, along_imaginary_;
    std::vector<std::complex<float>> down_;
};

}  // namespace ossuary::descriptor
