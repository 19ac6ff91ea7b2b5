#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/decomposition/segmentation.h"

namespace ossuary::decomposition {

/// Reads the text of a .seg file of the Princeton segmentation benchmark: a label a line for each
/// face of the model, any non-negative integers below 2^32; blank lines count for nothing. The
/// labels are renumbered in the order of their first use. `name` stands for the file in messages.
/// Errors: seg_invalid (what is not a label, or another number of labels than `faces`).
Result<Segmentation> parse_seg(std::string_view text, std::string_view name, std::size_t faces);

/// The same from a file. Errors also: file_not_found, file_unreadable.
Result<Segmentation> read_seg(const std::filesystem::path& path, std::size_t faces);

/// The labels as the text of a .seg file, one a line.
[[nodiscard]] std::string to_seg(const Segmentation& segmentation);

/// The segmentations of one model, `N/N_0.seg`, `N/N_1.seg` … under `folder`, in the order of
/// their names; empty where there is no such folder. Errors: those of read_seg.
Result<std::vector<Segmentation>> read_segmentations(const std::filesystem::path& folder,
                                                     const std::string& model, std::size_t faces);

}  // namespace ossuary::decomposition
