#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/ranking/ranker.h"

namespace ossuary::ranking {

/// The signatures of a collection in one block of memory, a byte a value, for an exact scan:
/// 100,000 of them are 26 MB and take a few milliseconds. On the Princeton collections the L1
/// distance of bytes finds the nearest models better than the Euclidean one of floats (first tier
/// of all 19 classes .692 against .650).
class Preselection {
public:
    Preselection() = default;
    explicit Preselection(DescriptorSpan collection);

    [[nodiscard]] std::size_t size() const { return count_; }

    /// The `count` models with the nearest signatures, ascending by index; of equally near ones
    /// those with lower indices.
    /// @param among  indices that may be taken, ascending; of all models without
    [[nodiscard]] std::vector<std::uint32_t> nearest(
        std::span<const float> signature, std::size_t count,
        std::optional<std::span<const std::uint32_t>> among = {}) const;

private:
    std::size_t count_ = 0;
    std::vector<std::uint8_t> bytes_;
};

struct RankedModel {
    std::size_t index = 0;  ///< in the collection
    double distance = 0.0;
};

struct NearestOptions {
    std::size_t count = 10;  ///< models wanted
    /// So many more, as far as the finalists go, for who leaves some of them out. They do not make
    /// a search exhaustive.
    std::size_t spare = 0;
    /// Up to this many models all are measured, so that nothing can be missed.
    std::size_t exhaustive_below = 2000;
    std::size_t by_signature = 8000;  ///< models that pass the scan of signatures
    std::size_t by_globals = 800;     ///< of those, models that pass the global descriptors
    /// Indices of the models that may be hits, ascending; all without. The scan and what follows
    /// look at no other, and each model is at the same distance as without it, except with
    /// `rerank`, where all places are found first.
    std::optional<std::span<const std::uint32_t>> among = {};
};

/// The nearest models of a large collection, nearest first, equal distances by index: a scan of all
/// signatures, the global descriptors of what is left, then the ranker's own distance of the
/// finalists, bit by bit that of rank_distances. The thesis' `chain-code`, parts, more than a tenth
/// of the finalists wanted, and small collections are measured exhaustively. With `rerank` the
/// nearest 200 finalists change places among themselves. Errors: cancelled.
/// @param preselection  of this collection
Result<std::vector<RankedModel>> nearest_models(const descriptor::ModelDescriptor& query,
                                                DescriptorSpan collection,
                                                const Preselection& preselection,
                                                const CollectionStatistics& statistics,
                                                const RankOptions& options,
                                                const NearestOptions& nearest = {});

}  // namespace ossuary::ranking
