#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/descriptor_source.h"
#include "engine/ranking/ranker.h"
#include "engine/ranking/retrieval_metrics.h"
#include "index/model.h"
#include "index/snapshot.h"
#include "index/store.h"
#include "index/store_pool.h"

namespace ossuary::index {

struct EvaluateOptions {
    /// Evaluate the models that it names, in its order and with its classes; none = all models of
    /// the index that have a class, in the order of their ids.
    std::optional<ranking::Classification> classification;
    ranking::RankOptions rank;
    /// Of more queries than this, so many are drawn, the same for the same collection, and searched
    /// with in all of it; 0 = all of them.
    std::size_t sample = 0;
};

struct Evaluation {
    ranking::RankerKind ranker = ranking::RankerKind::kHybrid;
    bool rerank = false;
    double pose = 0.0;
    ranking::RetrievalReport report;
    ranking::DistanceMatrix
        distances;                    ///< empty when the report came from the cache or of a sample
    std::vector<ModelId> order;       ///< of rows and columns
    std::vector<std::string> labels;  ///< class of each row
    /// What the classification names and the index does not have.
    std::vector<std::string> missing;
    std::size_t queries = 0;  ///< of which `report.models` were searched with
    Revision revision = 0;
    std::string computed_at;  ///< ISO 8601, UTC
};

/// The models of a snapshot that a classification names, in its order.
struct ClassifiedModels {
    std::vector<std::size_t> positions;  ///< in the snapshot
    std::vector<std::string> labels;
    std::vector<std::string> missing;
};

/// Errors: cla_unknown_model when the snapshot has none of them, invalid_argument when a name may
/// stand for several.
Result<ClassifiedModels> classified_models(const Snapshot& snapshot, StorePool& stores,
                                           const ranking::Classification& classification);

/// The descriptors of models that a snapshot has at these positions, all in memory. Errors:
/// index_busy when one of them changes meanwhile, those of the store.
Result<std::vector<ranking::SharedDescriptor>> load_descriptors(
    const Snapshot& snapshot, StorePool& stores, std::span<const std::size_t> positions, int jobs);

/// Leave-one-out retrieval quality over a snapshot; a function of the snapshot and the options.
/// Errors: cla_unknown_model when the index has none of the classification's models,
/// invalid_argument when an id may stand for several of them or no class has two models, cancelled
/// once `rank.stop` asks, index_busy when models change while they are read. All descriptors of the
/// models and the matrix of their distances are in memory at once.
Result<Evaluation> evaluate(const Snapshot& snapshot, StorePool& stores,
                            const EvaluateOptions& options = {});

/// The same, from the store's cache when it has it; computed and kept there (if the store is
/// writable) when not. Cached evaluations come without distances.
Result<Evaluation> evaluate_cached(Store& store, const Snapshot& snapshot, StorePool& stores,
                                   const EvaluateOptions& options = {});

/// Writes the distances as little-endian float32, row by row: what the Princeton tools read.
Result<void> write_matrix(const std::filesystem::path& path,
                          const ranking::DistanceMatrix& distances);

}  // namespace ossuary::index
