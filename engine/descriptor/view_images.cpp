#include "engine/descriptor/view_images.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ossuary::descriptor {
namespace {

constexpr double kPanoramaReach = 3.0;  // radius of the cylinder, in mean distances
constexpr double kDepthReach = 2.4;     // half the image, in mean distances
/// Half a voxel and a little, so that neighbouring voxels leave no gap on the cylinder.
constexpr double kHalfVoxel = 0.6;

ViewImage blank(std::size_t rows, std::size_t columns) {
    ViewImage image{rows, columns, {}, {}};
    image.extent.assign(rows * columns, 0.0F);
    image.facing.assign(rows * columns, 0.0F);
    return image;
}

void paint(ViewImage& image, std::size_t row, std::size_t column, float extent, float facing) {
    const std::size_t pixel = row * image.columns + column;
    if (extent <= image.extent[pixel]) return;
    image.extent[pixel] = extent;
    image.facing[pixel] = facing;
}

/// A raster coordinate's pixel, those outside moved to the border.
std::size_t pixel_at(double position, std::size_t count) {
    return static_cast<std::size_t>(
        std::clamp(std::floor(position), 0.0, static_cast<double>(count - 1)));
}

}  // namespace

ViewImage panorama(const SolidSurface& surface, const PrincipalFrame& frame, int axis) {
    ViewImage image = blank(kPanoramaRows, kPanoramaColumns);
    const double scale = 1.0 / (kPanoramaReach * frame.mean_distance);
    const Vec3 u = frame.axes.row((axis + 1) % 3);
    const Vec3 v = frame.axes.row((axis + 2) % 3);
    const Vec3 w = frame.axes.row(axis);
    constexpr double kPerRadian = kPanoramaColumns / (2.0 * std::numbers::pi);
    constexpr int kColumns = static_cast<int>(kPanoramaColumns);
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const Vec3 offset = surface.points[i].cast<double>() - frame.center;
        const double x = offset.dot(u), y = offset.dot(v);
        const double radius = std::sqrt(x * x + y * y);
        if (radius < 1e-9) continue;  // on the axis: no side of the cylinder is nearest
        const Vec3 normal = surface.normals[i].cast<double>();
        const double facing = std::abs(normal.dot(u) * x + normal.dot(v) * y) / radius;
        const double angle = std::atan2(y, x);
        const double half = std::min(kHalfVoxel / radius, std::numbers::pi);
        const int first = static_cast<int>(std::floor((angle - half) * kPerRadian));
        const int last = static_cast<int>(std::floor((angle + half) * kPerRadian));
        const double height = (offset.dot(w) * scale + 1.0) * 0.5 * kPanoramaRows;
        const double half_pixel = 0.25 * scale * kPanoramaRows;
        const std::size_t top = pixel_at(height + half_pixel, kPanoramaRows);
        for (int column = first; column <= std::min(last, first + kColumns - 1); ++column) {
            const int around = ((column % kColumns) + kColumns) % kColumns;
            for (std::size_t row = pixel_at(height - half_pixel, kPanoramaRows); row <= top;
                 ++row) {
                paint(image, row, static_cast<std::size_t>(around),
                      static_cast<float>(std::min(radius * scale, 1.0)),
                      static_cast<float>(facing));
            }
        }
    }
    return image;
}

std::array<ViewImage, 2> depth_images(const SolidSurface& surface, const PrincipalFrame& frame,
                                      int axis) {
    std::array<ViewImage, 2> images = {blank(kDepthSide, kDepthSide),
                                       blank(kDepthSide, kDepthSide)};
    const double scale = 1.0 / (kDepthReach * frame.mean_distance);
    const Vec3 u = frame.axes.row((axis + 1) % 3) * scale;
    const Vec3 v = frame.axes.row((axis + 2) % 3) * scale;
    const Vec3 w = frame.axes.row(axis);
    const double half_pixel = 0.25 * scale * kDepthSide;  // half a voxel on the raster
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const Vec3 offset = surface.points[i].cast<double>() - frame.center;
        const double column = (offset.dot(u) + 1.0) * 0.5 * kDepthSide;
        const double row = (offset.dot(v) + 1.0) * 0.5 * kDepthSide;
        const double depth = std::clamp(offset.dot(w) * scale, -1.0, 1.0);
        const auto facing = static_cast<float>(std::abs(surface.normals[i].cast<double>().dot(w)));
        const std::size_t right = pixel_at(column + half_pixel, kDepthSide);
        const std::size_t bottom = pixel_at(row + half_pixel, kDepthSide);
        for (std::size_t y = pixel_at(row - half_pixel, kDepthSide); y <= bottom; ++y) {
            for (std::size_t x = pixel_at(column - half_pixel, kDepthSide); x <= right; ++x) {
                paint(images[0], y, x, static_cast<float>(0.5 + 0.5 * depth), facing);
                paint(images[1], y, x, static_cast<float>(0.5 - 0.5 * depth), facing);
            }
        }
    }
    return images;
}

}  // namespace ossuary::descriptor
