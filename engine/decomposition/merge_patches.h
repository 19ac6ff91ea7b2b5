#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/decomposition/patches.h"

namespace ossuary::decomposition {

struct MergePatchesOptions {
    /// The number of parts; 0 leaves it to the evidence.
    std::size_t parts = 0;
};

/// Joins patches to parts, each of them connected. The two linked parts whose patches most probably
/// belong together on average go first (average linkage). Joining gains, in expectation, the pairs
/// of triangles put right less those put wrong; merging ends where the sum of the gains is largest,
/// which is where the expected Rand index is, or at the wanted number of parts.
/// @param together  for each pair of patches (PatchPairs::index) the probability that people put
///                  them into one part
/// @returns the part of each patch, numbered from 0
std::vector<std::uint32_t> merge_patches(const PatchGraph& graph, std::span<const float> together,
                                         const MergePatchesOptions& options = {});

}  // namespace ossuary::decomposition
