#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/core/stopwatch.h"
#include "engine/decomposition/decompose.h"
#include "engine/mesh/triangle_mesh.h"
#include "index/evaluation.h"
#include "index/indexer.h"
#include "index/model.h"
#include "index/searcher.h"
#include "index/store.h"

namespace ossuary::index {

// The JSON that the command line prints and the server sends; one place, so that they agree.

[[nodiscard]] nlohmann::json to_json(const Box3& box);  ///< {min, max}
[[nodiscard]] nlohmann::json to_json(const std::vector<mesh::MeshWarning>& warnings);
[[nodiscard]] nlohmann::json to_json(const StageTimes& times);  ///< {stage: ms}
[[nodiscard]] nlohmann::json to_json(const std::vector<matching::DistancePart>& parts);
[[nodiscard]] nlohmann::json to_json(const matching::Correspondence& match);
[[nodiscard]] nlohmann::json to_json(const StoredSkeleton& skeleton);
/// A skeleton without chain codes; `unit` is "model" or "voxel".
[[nodiscard]] nlohmann::json to_json(const skeleton::SkeletonGraph& graph,
                                     std::string_view unit = "model");
/// A part without its number: {triangles, area, area_share, branch, neighbors}; the branch is null
/// where it has none.
[[nodiscard]] nlohmann::json to_json(const decomposition::Decomposition::Part& part,
                                     double total_area);
[[nodiscard]] nlohmann::json to_json(const PreviewMesh& mesh, const Box3& bounds);
[[nodiscard]] nlohmann::json to_json(const ModelSummary& model);  ///< without links
[[nodiscard]] nlohmann::json to_json(const Failure& failure);
[[nodiscard]] nlohmann::json to_json(const Hit& hit);
[[nodiscard]] nlohmann::json to_json(const Comparison& comparison,
                                     const ranking::RankOptions& options);
[[nodiscard]] nlohmann::json to_json(const Evaluation& evaluation);
/// Each query of an evaluation with its model's name and class and its measures; the catalogue
/// of the snapshot knows the names, empty for models that it has not.
[[nodiscard]] nlohmann::json queries_json(const Evaluation& evaluation, const Snapshot& snapshot,
                                          const Catalogue& catalogue);
[[nodiscard]] nlohmann::json to_json(const PassedOver& passed_over);
[[nodiscard]] nlohmann::json to_json(const IndexOutcome& outcome);
[[nodiscard]] nlohmann::json to_json(const VerifyReport& report);
[[nodiscard]] nlohmann::json to_json(const IndexParameters& parameters);

/// What a search answer says of its query.
struct QueryDescription {
    std::string name;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    FileFrame frame = {};
    /// How it is best looked at: as its file says, else as found; none = nobody asked.
    std::optional<Up> up = {};
};
/// A whole search answer.
[[nodiscard]] nlohmann::json to_json(const SearchResult& result, const QueryDescription& query,
                                     const ranking::RankOptions& options);

}  // namespace ossuary::index
