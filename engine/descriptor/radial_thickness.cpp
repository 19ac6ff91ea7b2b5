#include "engine/descriptor/radial_thickness.h"

#include <cassert>
#include <cmath>

#include "engine/descriptor/histogram.h"
#include "engine/descriptor/quantize.h"
#include "engine/descriptor/shell_center.h"

namespace ossuary::descriptor {
namespace {}  // namespace

std::vector<std::uint8_t> radial_thickness(const ShellGraph& graph,
                                           std::span<const float> diameters) {
    assert(diameters.size() == graph.size());
    SoftHistogram<3> histogram(
        {{{0.0, 2.2, 12}, {std::log(0.01), std::log(0.8), 10}, {-1.0, 1.0, 5}}});
    const ShellCenter center = shell_center(graph);
    const double scale = std::sqrt(graph.total_area);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const Vec3f offset = graph.points[i] - center.center;
        const float radius = offset.norm();
        const float outward = radius > 0.0F ? graph.normals[i].dot(offset) / radius : 0.0F;
        histogram.add(
            {static_cast<double>(radius) / center.mean_distance,
             std::log(static_cast<double>(diameters[i]) / scale), static_cast<double>(outward)},
            static_cast<double>(graph.areas[i]));
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(kRadialThicknessSize);
    append_root_bytes(histogram.normalized(), kHistogramByteScale, bytes);
    return bytes;
}

}  // namespace ossuary::descriptor
