#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/shell_graph.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kSurfacePairsSize = 8 * 5 * 5 * 5;

/// How pairs of oriented points of the surface lie to each other: the joint histogram of their
/// distance over the square root of the area, of the cosines between each normal and the line that
/// joins them (the greater first, so that a pair has no order) and of the cosine between the
/// normals (Wahl, Hillenbrand and Hirzinger, "Surflet-pair-relation histograms", 3DIM 2003).
/// Over all pairs of at most 300 nodes, so without a random number; square roots in bytes.
std::vector<std::uint8_t> surface_pairs(const ShellGraph& graph);

/// The sum of absolute differences of the histograms themselves: the bytes squared.
/// @pre both are of one length
[[nodiscard]] double squared_byte_distance(std::span<const std::uint8_t> a,
                                           std::span<const std::uint8_t> b);

}  // namespace ossuary::descriptor
