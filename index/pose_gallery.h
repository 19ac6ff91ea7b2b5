#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "index/evaluation.h"
#include "index/snapshot.h"
#include "index/store.h"

namespace ossuary::index {

/// A model beside the nearest of its own class when build alone decides and when pose does.
struct PoseExample {
    std::string class_name;
    ModelId model = 0;
    ModelId by_build = 0;  ///< with pose 0
    ModelId by_pose = 0;   ///< with pose 1
};

/// At most `per_class` models of each class with three models or more, spread over it, under
/// `skeleton`. Errors: those of load_descriptors.
/// @pre the evaluation is of this snapshot, with its order and labels
Result<std::vector<PoseExample>> pose_examples(const Snapshot& snapshot, StorePool& stores,
                                               const Evaluation& evaluation,
                                               std::size_t per_class = 5, int jobs = 1);

/// One page with the three pictures of each example, which needs nothing else. `before` is markup
/// that comes first. Errors: those of
/// reading the store; a model without a thumbnail is shown by its name.
Result<std::string> pose_gallery_html(Store& store, std::span<const PoseExample> examples,
                                      const std::string& before = "");

/// Writes it to poses.html in `folder`, which is made if need be.
Result<void> write_pose_gallery(const std::filesystem::path& folder, Store& store,
                                std::span<const PoseExample> examples,
                                const std::string& before = "");

}  // namespace ossuary::index
