#pragma once

#include <vector>

#include "engine/descriptor/solid_surface.h"

namespace ossuary {

/// Which covariance gives the frame that the images are taken in.
enum class DepthFrame {
    kPositions,  ///< of the surface's points: long axes first
    kNormals,    ///< of its normals: the main walls face the axes
};

inline constexpr int kDepthFrequencies = 8;
inline constexpr int kDepthFourierSize = 3 * 2 * kDepthFrequencies * kDepthFrequencies;

/// Depth images along the three principal axes, from both sides, as the magnitudes of their low
/// frequencies (after Vranic, "DESIRE: a composite 3D-shape descriptor", ICME 2005, sec. 3; two
/// frames after Papadakis et al., "Efficient 3D shape matching and retrieval using a concrete
/// radialized spherical projection representation", 2007, sec. 2). Magnitudes forget small shifts;
/// mirrored frequencies are averaged and the two sides enter as mean and difference, so that the
/// axes' signs do not matter either. Compare by L1.
std::vector<float> depth_fourier(const SolidSurface& surface, DepthFrame frame);

}  // namespace ossuary
