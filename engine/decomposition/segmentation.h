#pragma once

#include <cstdint>
#include <vector>

namespace ossuary::decomposition {

/// A part number for each triangle of a mesh (or each face of a file), 0-based and dense: every
/// number below `parts` occurs.
struct Segmentation {
    std::vector<std::uint32_t> labels;
    std::uint32_t parts = 0;

    [[nodiscard]] bool empty() const { return labels.empty(); }
    bool operator==(const Segmentation&) const = default;
};

/// Renumbers any labels in the order of their first use.
[[nodiscard]] Segmentation dense_segmentation(const std::vector<std::uint32_t>& labels);

}  // namespace ossuary::decomposition
