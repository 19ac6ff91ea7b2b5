#include "engine/descriptor/depth_fourier.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace ossuary {
namespace {

constexpr int kImage = 64;
constexpr double kReach = 2.4;  // half the image, in mean distances of the surface from its centre
constexpr std::size_t kSide = static_cast<std::size_t>(kImage);
constexpr std::size_t kKept = static_cast<std::size_t>(kDepthFrequencies);

using Image = std::vector<float>;  // kSide x kSide, row by row; 0 is background, 1 is nearest

struct Frame {
    Vec3 center = Vec3::Zero();
    Mat3 axes = Mat3::Identity();  // rows, longest first
    double mean_distance = 1.0;
};

Frame principal_frame(const SolidSurface& surface, DepthFrame kind) {
    Frame frame;
    const auto weight = [&](std::size_t i) {
        return static_cast<double>(surface.areas[i]) / surface.total_area;
    };
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        frame.center += weight(i) * surface.points[i].cast<double>();
    }
    Mat3 covariance = Mat3::Zero();
    frame.mean_distance = 0.0;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const Vec3 offset = surface.points[i].cast<double>() - frame.center;
        frame.mean_distance += weight(i) * offset.norm();
        const Vec3 v = kind == DepthFrame::kPositions ? offset : surface.normals[i].cast<double>();
        covariance += weight(i) * v * v.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
    for (int axis = 0; axis < 3; ++axis) {
        frame.axes.row(axis) = solver.eigenvectors().col(2 - axis).transpose();
    }
    return frame;
}

/// The images of the surface seen along `axis` from the positive and the negative side, on the same
/// raster.
std::array<Image, 2> depth_images(const SolidSurface& surface, const Frame& frame, int axis) {
    std::array<Image, 2> images = {Image(kSide * kSide, 0.0F), Image(kSide * kSide, 0.0F)};
    const double scale = 1.0 / (kReach * frame.mean_distance);
    const Vec3 u = frame.axes.row((axis + 1) % 3) * scale;
    const Vec3 v = frame.axes.row((axis + 2) % 3) * scale;
    const Vec3 w = frame.axes.row(axis) * scale;
    const double half_pixel = 0.5 * scale * kImage / 2.0;  // of a voxel on the raster
    for (const Vec3f& point : surface.points) {
        const Vec3 offset = point.cast<double>() - frame.center;
        const auto raster = [](double at) {
            return std::clamp(static_cast<int>(std::floor(at)), 0, kImage - 1);
        };
        const double column = (offset.dot(u) + 1.0) * kImage / 2.0;
        const double row = (offset.dot(v) + 1.0) * kImage / 2.0;
        const double depth = std::clamp(offset.dot(w), -1.0, 1.0);
        const float front = static_cast<float>(0.5 + 0.5 * depth);
        const float back = static_cast<float>(0.5 - 0.5 * depth);
        for (int y = raster(row - half_pixel); y <= raster(row + half_pixel); ++y) {
            for (int x = raster(column - half_pixel); x <= raster(column + half_pixel); ++x) {
                const std::size_t pixel =
                    static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
                images[0][pixel] = std::max(images[0][pixel], front);
                images[1][pixel] = std::max(images[1][pixel], back);
            }
        }
    }
    return images;
}

/// exp(-2 pi i k x / kSide) for the kept frequencies.
struct Waves {
    std::array<std::array<std::complex<float>, kSide>, kKept> value;
    Waves() {
        for (std::size_t k = 0; k < kKept; ++k) {
            for (std::size_t x = 0; x < kSide; ++x) {
                value[k][x] = std::complex<float>(
                    std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(k * x) / kImage));
            }
        }
    }
};

using Magnitudes = std::array<float, kKept * kKept>;

/// (|F(k, l)| + |F(k, -l)|) / 2 over the number of pixels.
Magnitudes magnitudes(const Image& image) {
    static const Waves kWaves;
    std::array<std::array<std::complex<float>, kSide>, kKept> rows{};
    for (std::size_t y = 0; y < kSide; ++y) {
        const float* pixels = image.data() + y * kSide;
        for (std::size_t k = 0; k < kKept; ++k) {
            float real = 0.0F, imaginary = 0.0F;
            for (std::size_t x = 0; x < kSide; ++x) {
                real += pixels[x] * kWaves.value[k][x].real();
                imaginary += pixels[x] * kWaves.value[k][x].imag();
            }
            rows[k][y] = {real, imaginary};
        }
    }
    Magnitudes result{};
    constexpr float kPixels = static_cast<float>(kImage * kImage);
    for (std::size_t k = 0; k < kKept; ++k) {
        for (std::size_t l = 0; l < kKept; ++l) {
            std::complex<float> plus = 0.0F, minus = 0.0F;
            for (std::size_t y = 0; y < kSide; ++y) {
                plus += rows[k][y] * kWaves.value[l][y];
                minus += rows[k][y] * std::conj(kWaves.value[l][y]);
            }
            result[l * kKept + k] = 0.5F * (std::abs(plus) + std::abs(minus)) / kPixels;
        }
    }
    return result;
}

}  // namespace

std::vector<float> depth_fourier(const SolidSurface& surface, DepthFrame kind) {
    std::vector<float> values;
    values.reserve(kDepthFourierSize);
    if (surface.empty()) return std::vector<float>(kDepthFourierSize, 0.0F);
    const Frame frame = principal_frame(surface, kind);
    for (int axis = 0; axis < 3; ++axis) {
        const std::array<Image, 2> images = depth_images(surface, frame, axis);
        const Magnitudes front = magnitudes(images[0]);
        const Magnitudes back = magnitudes(images[1]);
        for (std::size_t i = 0; i < front.size(); ++i) {
            values.push_back(0.5F * (front[i] + back[i]));
        }
        for (std::size_t i = 0; i < front.size(); ++i) {
            values.push_back(0.5F * std::abs(front[i] - back[i]));
        }
    }
    return values;
}

}  // namespace ossuary
