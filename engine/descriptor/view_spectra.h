#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/solid_surface.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kViewFrames = 2;
/// Of one view: 16 x 9 frequencies of the panorama's extent and facing, and 8 x 8 of the depth
/// images' extent (mean of both sides, difference) and facing (the same).
inline constexpr std::size_t kPanoramaSpectrum = 16 * 9;
inline constexpr std::size_t kDepthFrequencies = 8;
inline constexpr std::size_t kDepthSpectrum = kDepthFrequencies * kDepthFrequencies;
inline constexpr std::size_t kViewSize = 2 * kPanoramaSpectrum + 4 * kDepthSpectrum;
inline constexpr std::size_t kViewSpectraSize = kViewFrames * 3 * kViewSize;

/// How the surface looks along and around the three axes of two frames of its own (by positions and
/// by normals): magnitudes of the low frequencies of panoramas and depth images, square roots in
/// bytes. Magnitudes do not know the signs of the axes.
/// Sources: view_images.h; two frames after Papadakis et al., "Efficient 3D shape matching and
/// retrieval using a concrete radialized spherical projection representation", 2007, sec. 2.
std::vector<std::uint8_t> view_spectra(const SolidSurface& surface);

/// For each frame the least sum of absolute differences over the six ways of assigning the three
/// axes of one to those of the other, because axes of similar length change places between similar
/// shapes (2 points of first tier on the shape benchmark); both frames added. Symmetric.
/// @pre both are of kViewSpectraSize bytes
[[nodiscard]] double view_distance(std::span<const std::uint8_t> a,
                                   std::span<const std::uint8_t> b);

}  // namespace ossuary::descriptor
