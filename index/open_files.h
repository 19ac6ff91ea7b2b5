#pragma once

#include <filesystem>
#include <stop_token>
#include <vector>

#include "index/model_files.h"
#include "index/model_reader.h"

namespace ossuary::index {

/// Puts what ZIP archives hold in their place among the files that a walk of `roots` (as
/// index_path) has found: the models of one that holds several, each as path_of; nothing for one
/// that holds none and is no root itself. Archives of one model stay as they are, and those that
/// cannot be opened. What is hidden or excluded by its name in the archive is passed over as in a
/// folder. Errors: cancelled.
Result<void> open_archives(FoundFiles& found, const std::vector<std::filesystem::path>& roots,
                           const WalkOptions& options, ModelReader& reader,
                           const std::stop_token& stop);

/// Puts the objects of files that hold several (ModelReader::list_objects) in the place of these;
/// those that cannot be read stay. Reads every file.
/// @param jobs  files at once; 0 = hardware threads
/// Errors: cancelled.
Result<void> split_files(FoundFiles& found, ModelReader& reader, int jobs,
                         const std::stop_token& stop);

}  // namespace ossuary::index
