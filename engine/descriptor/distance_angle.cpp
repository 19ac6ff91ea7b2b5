#include "engine/descriptor/distance_angle.h"

#include <cmath>

#include "engine/descriptor/histogram.h"

namespace ossuary {
namespace {

constexpr std::size_t kMaxPoints = 700;

}  // namespace

std::vector<float> distance_angle(const SolidSurface& surface) {
    JointHistogram histogram({0.0, 1.5, 32}, {0.0, 1.0, 8});
    // Every stride-th point; they run along the grid, so the strides spread over the surface.
    const std::size_t stride = (surface.points.size() + kMaxPoints - 1) / kMaxPoints;
    const float scale = 1.0F / static_cast<float>(std::sqrt(surface.total_area));
    for (std::size_t i = 0; i < surface.points.size(); i += stride) {
        for (std::size_t j = i + stride; j < surface.points.size(); j += stride) {
            const float distance = (surface.points[i] - surface.points[j]).norm() * scale;
            const float cosine = std::abs(surface.normals[i].dot(surface.normals[j]));
            histogram.add(static_cast<double>(distance), static_cast<double>(cosine),
                          static_cast<double>(surface.areas[i] * surface.areas[j]));
        }
    }
    return histogram.normalized();
}

}  // namespace ossuary
