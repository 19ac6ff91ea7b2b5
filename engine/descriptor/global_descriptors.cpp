#include "engine/descriptor/global_descriptors.h"

#include <cassert>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "engine/descriptor/body_scale.h"
#include "engine/descriptor/byte_distance.h"
#include "engine/descriptor/shape_diameter.h"
#include "engine/descriptor/shell_graph.h"

namespace ossuary::descriptor {
namespace {

/// Voxels to a node of the graph: keeps a model at about 1,500 nodes.
constexpr int kCellSize = 4;
/// Mean distances are of the first of the sources that pairs of thicknesses are taken from.
constexpr int kGeodesicSources = 16;
constexpr int kPairSources = 32;

/// How many of the kinds, the first ones, are of skeletons.
constexpr std::size_t kSkeletonDescriptors = 2;

/// @param first  the kind that the first of `globals` is of
void add_global(std::size_t first, std::vector<std::uint8_t> values,
                std::vector<GlobalDescriptor>& globals) {
    const GlobalDescriptorKind& kind = kGlobalDescriptorKinds[first + globals.size()];
    assert(values.size() == kind.size);
    globals.push_back({std::string(kind.name), std::move(values)});
}

}  // namespace

std::vector<GlobalDescriptor> skeleton_descriptors(
    std::span<const matching::SkeletonDescriptor> skeletons, const std::stop_token& stop) {
    std::vector<GlobalDescriptor> globals;
    add_global(0, skeleton_pairs(skeletons, stop), globals);
    add_global(0, skeleton_layout(skeletons, stop), globals);
    return globals;
}

std::vector<GlobalDescriptor> solid_descriptors(const SolidSurface& surface,
                                                const voxel::BitVolume& solid,
                                                const WorldFromGrid& world,
                                                const std::stop_token& stop) {
    const ShellGraph graph = shell_graph(surface, kCellSize);
    std::vector<GlobalDescriptor> globals;
    const auto add = [&](std::vector<std::uint8_t> values) {
        add_global(kSkeletonDescriptors, std::move(values), globals);
    };
    add(view_spectra(surface));
    if (stop.stop_requested()) return globals;
    add(surface_pairs(graph));
    if (stop.stop_requested()) return globals;
    const SpreadDistances spread = spread_distances(graph, kPairSources);
    add(local_volume(graph, average_geodesic_distances(graph, spread, kGeodesicSources), solid));
    if (stop.stop_requested()) return globals;
    const std::vector<float> diameters = shape_diameters(graph, solid);
    const double scale = body_scale(surface.total_area, static_cast<double>(solid.count()));
    add(radial_thickness(graph, diameters));
    add(thickness(graph, diameters, scale));
    add(thickness_pairs(graph, spread, diameters, scale));
    add(pose_points(graph, scale, world.rotation));
    add(body_size(world.length(scale)));
    return globals;
}

std::vector<GlobalDescriptor> global_descriptors(
    const SolidSurface& surface, const voxel::BitVolume& solid,
    std::span<const matching::SkeletonDescriptor> skeletons, const WorldFromGrid& world,
    const std::stop_token& stop) {
    std::vector<GlobalDescriptor> globals = skeleton_descriptors(skeletons, stop);
    if (stop.stop_requested()) return globals;
    std::vector<GlobalDescriptor> of_solid = solid_descriptors(surface, solid, world, stop);
    globals.insert(globals.end(), std::make_move_iterator(of_solid.begin()),
                   std::make_move_iterator(of_solid.end()));
    return globals;
}

double global_distance(const GlobalDescriptor& a, const GlobalDescriptor& b,
                       const GlobalDescriptorKind& kind, double pose) {
    if (a.values.size() != kind.size || b.values.size() != kind.size) {
        return std::numeric_limits<double>::infinity();
    }
    switch (kind.metric) {
        case GlobalMetric::kSkeletonPairs:
            return skeleton_pairs_distance(a.values, b.values, pose);
        case GlobalMetric::kManhattan:
            return byte_distance(a.values.data(), b.values.data(), kind.size);
        case GlobalMetric::kSquaredManhattan:
            return squared_byte_distance(a.values, b.values);
        case GlobalMetric::kViews:
            return view_distance(a.values, b.values);
        case GlobalMetric::kPose:
            return pose_points_distance(a.values, b.values);
        case GlobalMetric::kSize:
            return body_size_distance(a.values, b.values);
    }
    assert(false);
    return 0.0;
}

}  // namespace ossuary::descriptor
