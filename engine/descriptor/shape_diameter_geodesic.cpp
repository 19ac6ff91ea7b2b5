#include "engine/descriptor/shape_diameter_geodesic.h"

#include <cmath>

#include "engine/descriptor/histogram.h"
#include "engine/descriptor/shape_diameter.h"

namespace ossuary {
namespace {

constexpr int kBins = 16;
constexpr int kSources = 16;

}  // namespace

std::vector<float> shape_diameter_geodesic(const ShellGraph& surface, const BitVolume& solid) {
    JointHistogram histogram({std::log(0.01), std::log(0.8), kBins},
                             {std::log(0.25), std::log(2.0), kBins});
    const std::vector<float> diameters = shape_diameters(surface, solid);
    const std::vector<float> geodesics = average_geodesic_distances(surface, kSources);
    const double scale = std::sqrt(surface.total_area);
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const double diameter = std::log(static_cast<double>(diameters[i]) / scale);
        const double geodesic = std::log(static_cast<double>(geodesics[i]) / scale);
        histogram.add(diameter, geodesic, static_cast<double>(surface.areas[i]));
    }
    return histogram.normalized();
}

}  // namespace ossuary
