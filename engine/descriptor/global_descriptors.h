#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/descriptor/model_descriptor.h"
#include "engine/descriptor/solid_surface.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary {

enum class GlobalMetric {
    kManhattan,
    kEuclidean,
};

struct GlobalDescriptorKind {
    std::string_view name;
    std::size_t size = 0;
    GlobalMetric metric = GlobalMetric::kManhattan;
};

/// What ModelDescriptor::globals holds, in order.
inline constexpr std::array kGlobalDescriptorKinds = {
    GlobalDescriptorKind{"shape_diameter_geodesic", 256, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"spherical_harmonics", 544, GlobalMetric::kEuclidean},
    GlobalDescriptorKind{"depth_fourier_positions", 384, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"depth_fourier_normals", 384, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"distance_angle", 256, GlobalMetric::kManhattan},
};

/// All global descriptors of a solid.
/// @param surface  solid_surface(solid)
std::vector<GlobalDescriptor> global_descriptors(const SolidSurface& surface,
                                                 const BitVolume& solid);

/// The distance of two global descriptors of one kind; 0 for equal ones, symmetric bit by bit. A
/// descriptor of another length (made by another version) is taken as infinitely far.
[[nodiscard]] double global_distance(const GlobalDescriptor& a, const GlobalDescriptor& b,
                                     GlobalMetric metric);

}  // namespace ossuary
