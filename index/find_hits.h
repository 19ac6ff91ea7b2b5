#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/stopwatch.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/ranking/preselection.h"
#include "engine/registration/piece_search.h"
#include "index/descriptor_cache.h"
#include "index/searcher.h"
#include "index/snapshot.h"

// Private to the searcher: what it asks of one snapshot.

namespace ossuary::index {

struct Question {
    const Snapshot& snapshot;
    SnapshotDescriptors& descriptors;
    const descriptor::ModelDescriptor& query;
    const SearchOptions& options;
    ModelId left_out = 0;
    /// The query's surface, where it is looked for as a part; null: by its skeleton alone.
    const registration::PieceQuery* piece = nullptr;
};

/// What a search has found, without its query.
struct Found {
    std::vector<Hit> hits;
    StageTimes stages_ms;
    std::vector<mesh::MeshWarning> warnings;  ///< of the search
    std::size_t models = 0;
    Revision revision = 0;
    bool complete = true;  ///< nothing was missing that the snapshot knows of

    void move_into(SearchResult& result) &&;
};

[[nodiscard]] ranking::NearestOptions nearest_options(const Snapshot& snapshot,
                                                      const SearchOptions& options);

/// The positions of the models that may be hits, ascending; none where all may.
Result<std::optional<std::vector<std::uint32_t>>> looked_among(const Snapshot& snapshot,
                                                               Store& store,
                                                               const SearchOptions& options);

/// Of models that may be hits, nearest first, as many as are wanted; without the one that is left
/// out and, where that is asked for, without copies.
[[nodiscard]] std::vector<ranking::RankedModel> wanted(
    const Question& question, const std::vector<ranking::RankedModel>& models);

/// Hits without parts and correspondences; adds the position of each to `positions`. Models that
/// are gone are none, and the answer is then not complete.
Result<void> add_hits(const Question& question, Store& store,
                      const std::vector<ranking::RankedModel>& models,
                      std::vector<std::uint32_t>& positions, Found& found);

/// Parts and correspondences of hits; those whose descriptors are gone go, too.
Result<void> explain_hits(const Question& question, const std::vector<std::uint32_t>& positions,
                          std::vector<Hit>& hits);

/// What every answer says of the snapshot; numbers the hits.
void finish(const Question& question, Found& found);

/// Ranks the snapshot for a query, or for a part where the options say so, and explains the hits.
Result<Found> find_hits(const Question& question, Store& store);

/// The same for a part (part_search.h).
Result<Found> find_parts(const Question& question, Store& store);

}  // namespace ossuary::index
