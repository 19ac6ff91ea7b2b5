#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ossuary::decomposition {

/// For each group of triangles the label that most of its area has, the lowest among equals; -1
/// where none of them has a label.
/// @param group_of, label_of, area  of each triangle; labels below 0 stand for none
std::vector<std::int32_t> prevailing_labels(std::size_t groups,
                                            std::span<const std::uint32_t> group_of,
                                            std::span<const std::int32_t> label_of,
                                            std::span<const double> area);

}  // namespace ossuary::decomposition
