#include "engine/descriptor/image_spectrum.h"

#include <algorithm>
#include <cassert>
#include <numbers>

namespace ossuary::descriptor {
namespace {

std::complex<double> wave(std::size_t frequency, std::size_t at, std::size_t count) {
    const auto turns = static_cast<double>(frequency * at) / static_cast<double>(count);
    return std::polar(1.0, -2.0 * std::numbers::pi * turns);
}

}  // namespace

ImageSpectrum::ImageSpectrum(const Size& image, const Size& kept) : image_(image), kept_(kept) {
    assert(2 * kept.rows <= image.rows && 2 * kept.columns <= image.columns);
    // Frequencies fastest, so that the inner loop over them runs in vector registers.
    for (std::size_t x = 0; x < image.columns; ++x) {
        for (std::size_t k = 0; k < kept.columns; ++k) {
            along_real_.push_back(static_cast<float>(wave(k, x, image.columns).real()));
            along_imaginary_.push_back(static_cast<float>(wave(k, x, image.columns).imag()));
        }
    }
    for (std::size_t y = 0; y < image.rows; ++y) {
        for (std::size_t l = 0; l < kept.rows; ++l) {
            down_.push_back(std::complex<float>(wave(l, y, image.rows)));
        }
    }
}

std::vector<float> ImageSpectrum::magnitudes(std::span<const float> pixels) const {
    assert(pixels.size() == image_.rows * image_.columns);
    const std::size_t width = kept_.columns;
    std::vector<std::complex<float>> plus(kept_.rows * width), minus(plus.size());
    std::vector<float> real(width), imaginary(width);
    for (std::size_t y = 0; y < image_.rows; ++y) {
        const std::span<const float> row = pixels.subspan(y * image_.columns, image_.columns);
        std::fill(real.begin(), real.end(), 0.0F);
        std::fill(imaginary.begin(), imaginary.end(), 0.0F);
        bool empty = true;
        for (std::size_t x = 0; x < row.size(); ++x) {
            const float value = row[x];
            if (value == 0.0F) continue;  // most of an image is background
            empty = false;
            const float* cosine = along_real_.data() + x * width;
            const float* sine = along_imaginary_.data() + x * width;
            for (std::size_t k = 0; k < width; ++k) real[k] += value * cosine[k];
            for (std::size_t k = 0; k < width; ++k) imaginary[k] += value * sine[k];
        }
        if (empty) continue;
        for (std::size_t l = 0; l < kept_.rows; ++l) {
            const std::complex<float> w = down_[y * kept_.rows + l];
            for (std::size_t k = 0; k < width; ++k) {
                const float rr = real[k] * w.real(), ii = imaginary[k] * w.imag();
                const float ri = real[k] * w.imag(), ir = imaginary[k] * w.real();
                plus[l * width + k] += std::complex<float>(rr - ii, ir + ri);
                minus[l * width + k] += std::complex<float>(rr + ii, ir - ri);
            }
        }
    }
    std::vector<float> result(plus.size());
    const auto scale = 0.5F / static_cast<float>(pixels.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const float p = std::sqrt(std::norm(plus[i])), m = std::sqrt(std::norm(minus[i]));
        result[i] = scale * (p + m);
    }
    return result;
}

}  // namespace ossuary::descriptor
