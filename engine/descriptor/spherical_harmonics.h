#pragma once

#include <vector>

#include "engine/descriptor/solid_surface.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary {

inline constexpr int kHarmonicShells = 32;
inline constexpr int kHarmonicDegrees = 17;  ///< l = 0 … 16

/// The energy of each degree of the spherical harmonics of the solid on concentric shells about
/// the surface's centre of gravity, out to twice the mean distance; the same for every rotation
/// (Kazhdan, Funkhouser and Rusinkiewicz, "Rotation invariant spherical harmonic representation of
/// 3D shape descriptors", SGP 2003, sec. 4). Shell by shell, each weighted by its radius, so that
/// the Euclidean distance is a volume integral. Compare by L2.
std::vector<float> spherical_harmonics(const SolidSurface& surface, const BitVolume& solid);

}  // namespace ossuary
