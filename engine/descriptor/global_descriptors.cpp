#include "engine/descriptor/global_descriptors.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "engine/descriptor/depth_fourier.h"
#include "engine/descriptor/distance_angle.h"
#include "engine/descriptor/shape_diameter_geodesic.h"
#include "engine/descriptor/shell_graph.h"
#include "engine/descriptor/spherical_harmonics.h"

namespace ossuary {
namespace {

/// Voxels to a node of the graph: a third of the resolution keeps a model at about 1,500 nodes.
constexpr int kCellSize = 4;

/// Eight running sums, so that the compiler may use vector registers without reordering anything.
template <typename Term>
double sum_of_terms(const std::vector<float>& a, const std::vector<float>& b, Term term) {
    constexpr std::size_t kLanes = 8;
    std::array<float, kLanes> lanes{};
    std::size_t i = 0;
    for (; i + kLanes <= a.size(); i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            lanes[lane] += term(a[i + lane] - b[i + lane]);
        }
    }
    for (std::size_t lane = 0; i < a.size(); ++i, ++lane) lanes[lane] += term(a[i] - b[i]);
    double total = 0.0;
    for (const float lane : lanes) total += static_cast<double>(lane);
    return total;
}

}  // namespace

std::vector<GlobalDescriptor> global_descriptors(const SolidSurface& surface,
                                                 const BitVolume& solid) {
    const ShellGraph graph = shell_graph(surface, kCellSize);
    std::vector<GlobalDescriptor> globals;
    const auto add = [&](std::vector<float> values) {
        const GlobalDescriptorKind& kind = kGlobalDescriptorKinds[globals.size()];
        assert(values.size() == kind.size);
        globals.push_back({std::string(kind.name), std::move(values)});
    };
    add(shape_diameter_geodesic(graph, solid));
    add(spherical_harmonics(surface, solid));
    add(depth_fourier(surface, DepthFrame::kPositions));
    add(depth_fourier(surface, DepthFrame::kNormals));
    add(distance_angle(surface));
    return globals;
}

double global_distance(const GlobalDescriptor& a, const GlobalDescriptor& b, GlobalMetric metric) {
    if (a.values.size() != b.values.size()) return std::numeric_limits<double>::infinity();
    if (metric == GlobalMetric::kManhattan) {
        return sum_of_terms(a.values, b.values, [](float d) { return std::abs(d); });
    }
    return std::sqrt(sum_of_terms(a.values, b.values, [](float d) { return d * d; }));
}

}  // namespace ossuary
