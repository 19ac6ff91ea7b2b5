#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/descriptor/body_size.h"
#include "engine/descriptor/local_volume.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/descriptor/pose_points.h"
#include "engine/descriptor/radial_thickness.h"
#include "engine/descriptor/skeleton_layout.h"
#include "engine/descriptor/skeleton_pairs.h"
#include "engine/descriptor/solid_surface.h"
#include "engine/descriptor/surface_pairs.h"
#include "engine/descriptor/thickness.h"
#include "engine/descriptor/view_spectra.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::descriptor {

enum class GlobalMetric {
    kSkeletonPairs,     ///< skeleton_pairs_distance
    kManhattan,         ///< sum of absolute differences of the bytes
    kSquaredManhattan,  ///< of their squares
    kViews,             ///< view_distance
    kPose,              ///< pose_points_distance
    kSize,              ///< body_size_distance
};

struct GlobalDescriptorKind {
    std::string_view name;
    std::size_t size = 0;  ///< bytes
    GlobalMetric metric = GlobalMetric::kManhattan;
};

/// What ModelDescriptor::globals holds, in order.
inline constexpr std::array kGlobalDescriptorKinds = {
    GlobalDescriptorKind{"skeleton_pairs", kSkeletonPairsSize, GlobalMetric::kSkeletonPairs},
    GlobalDescriptorKind{"skeleton_layout", kSkeletonLayoutSize, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"views", kViewSpectraSize, GlobalMetric::kViews},
    GlobalDescriptorKind{"surface_pairs", kSurfacePairsSize, GlobalMetric::kSquaredManhattan},
    GlobalDescriptorKind{"local_volume", kLocalVolumeSize, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"radial_thickness", kRadialThicknessSize, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"thickness", kThicknessSize, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"thickness_pairs", kThicknessPairsSize, GlobalMetric::kManhattan},
    GlobalDescriptorKind{"pose_points", kPosePointsSize, GlobalMetric::kPose},
    GlobalDescriptorKind{"body_size", kBodySizeSize, GlobalMetric::kSize},
};

/// Where in ModelDescriptor::globals each is.
enum GlobalPlace : std::size_t {
    kSkeletonPairsPlace,
    kSkeletonLayoutPlace,
    kViewsPlace,
    kSurfacePairsPlace,
    kLocalVolumePlace,
    kRadialThicknessPlace,
    kThicknessPlace,
    kThicknessPairsPlace,
    kPosePointsPlace,
    kBodySizePlace,
};

/// Those of kGlobalDescriptorKinds that are of skeletons: the first two.
std::vector<GlobalDescriptor> skeleton_descriptors(
    std::span<const matching::SkeletonDescriptor> skeletons, const std::stop_token& stop = {});

/// Those that are of the solid: the others. Parameters as below.
std::vector<GlobalDescriptor> solid_descriptors(const SolidSurface& surface,
                                                const voxel::BitVolume& solid,
                                                const WorldFromGrid& world,
                                                const std::stop_token& stop = {});

/// All global descriptors of a solid and its skeleton.
/// @param surface    solid_surface(solid)
/// @param skeletons  of the same model, made on one grid or several
/// @param world  where the solid's grid is in the file: what pose and size are measured in
/// @param stop  once requested, they are not complete
std::vector<GlobalDescriptor> global_descriptors(
    const SolidSurface& surface, const voxel::BitVolume& solid,
    std::span<const matching::SkeletonDescriptor> skeletons, const WorldFromGrid& world = {},
    const std::stop_token& stop = {});

/// The distance of two global descriptors of one kind; 0 for equal ones, symmetric bit by bit. A
/// descriptor of another length than the kind's (made by another version) is infinitely far.
/// @param pose  in [0, 1]: how far what bending changes counts, where it can be told apart
[[nodiscard]] double global_distance(const GlobalDescriptor& a, const GlobalDescriptor& b,
                                     const GlobalDescriptorKind& kind, double pose = 1.0);

}  // namespace ossuary::descriptor
