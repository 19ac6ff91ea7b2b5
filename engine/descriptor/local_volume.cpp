#include "engine/descriptor/local_volume.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/descriptor/histogram.h"
#include "engine/descriptor/quantize.h"
#include "engine/descriptor/shell_center.h"
#include "engine/descriptor/summed_volume.h"

namespace ossuary::descriptor {
namespace {

/// Half the cubes' edges over the square root of the area.
constexpr std::array<double, 3> kReaches = {0.05, 0.1, 0.2};

/// The share of set voxels in the cube about a point.
double filled_share(const SummedVolume& sums, const Vec3f& point, double reach) {
    const auto bound = [&](double side) {
        return (point.cast<double>().array() + side).round().cast<int>().matrix().eval();
    };
    const Vec3i low = bound(-reach), high = bound(reach);
    const int volume = std::max((high - low).prod(), 1);
    return sums.count(low, high) / static_cast<double>(volume);
}

}  // namespace

std::vector<std::uint8_t> local_volume(const ShellGraph& graph, std::span<const float> geodesics,
                                       const voxel::BitVolume& solid) {
    assert(geodesics.size() == graph.size());
    SoftHistogram<2> by_geodesic({{{0.0, 1.0, 12}, {std::log(0.25), std::log(2.0), 8}}});
    SoftHistogram<3> by_radius({{{0.0, 1.0, 8}, {0.0, 1.0, 8}, {0.0, 2.2, 6}}});
    const SummedVolume sums(solid);
    const ShellCenter center = shell_center(graph);
    const double scale = std::sqrt(graph.total_area);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        std::array<double, kReaches.size()> filled{};
        for (std::size_t k = 0; k < kReaches.size(); ++k) {
            filled[k] = filled_share(sums, graph.points[i], kReaches[k] * scale);
        }
        const auto area = static_cast<double>(graph.areas[i]);
        const double radius = static_cast<double>((graph.points[i] - center.center).norm());
        by_geodesic.add({filled[1], std::log(static_cast<double>(geodesics[i]) / scale)}, area);
        by_radius.add({0.5 * (filled[0] + filled[1]), filled[2], radius / center.mean_distance},
                      area);
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(kLocalVolumeSize);
    append_root_bytes(by_geodesic.normalized(), kHistogramByteScale, bytes);
    append_root_bytes(by_radius.normalized(), kHistogramByteScale, bytes);
    return bytes;
}

}  // namespace ossuary::descriptor
