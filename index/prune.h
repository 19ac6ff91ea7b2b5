#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "index/model.h"
#include "index/model_files.h"

namespace ossuary::index {

/// A folder (or a link to one) that seems to be out of reach rather than emptied.
struct PruneRefusal {
    std::filesystem::path place;
    std::size_t models = 0;  ///< that the index has of it
    std::size_t gone = 0;    ///< that would have been removed
};

/// What pruning removes.
struct PrunePlan {
    std::vector<ModelId> models;
    std::vector<std::string> failures;  ///< paths
    std::vector<PruneRefusal> refusals;
};

/// What an index has of the files of a run.
struct PruneInput {
    std::span<const std::string> paths_before;  ///< of the models, when the run began
    std::span<const ModelSummary> models;       ///< now
    std::span<const Failure> failures;          ///< now
};

/// Chooses what goes: what lies under `roots` and whose file is gone, or is there but passed over
/// by a walk with `options`. Nothing goes for which that is not certain: files in folders that
/// cannot be read, and files that can be indexed by being named.
///
/// A root under which no file was found, or that is not there, and a link that leads nowhere may be
/// a disk that is not mounted: if more than half of the models under it were to go, none does, and
/// the plan says so, unless `force`.
[[nodiscard]] PrunePlan plan_prune(const PruneInput& input,
                                   const std::vector<std::filesystem::path>& roots,
                                   const FoundFiles& found, const WalkOptions& options, bool force);

/// True when there is certainly no file at `path`; false also when that cannot be told.
[[nodiscard]] bool is_gone(const std::filesystem::path& path);

}  // namespace ossuary::index
