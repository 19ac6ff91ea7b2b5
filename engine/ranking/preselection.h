#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/ranking/descriptor_source.h"
#include "engine/ranking/normalization.h"
#include "engine/ranking/ranker.h"
#include "engine/ranking/scan_rows.h"

namespace ossuary::ranking {

/// What a search looks at of every model of a collection: the signatures, for an exact scan, and
/// the sketches of those that it leaves. The rows are the caller's and outlive this; a later
/// collection shares the blocks that have not changed.
class Preselection {
public:
    Preselection() = default;
    /// @param blocks  one after the other the whole collection
    explicit Preselection(std::vector<const ScanRows*> blocks);

    [[nodiscard]] std::size_t size() const { return first_.empty() ? 0 : first_.back(); }

    /// The `count` models with the nearest signatures, ascending by index; of equally near ones
    /// those with lower indices.
    /// @param among  indices that may be taken, ascending; of all models without
    [[nodiscard]] std::vector<std::uint32_t> nearest(
        std::span<const float> signature, std::size_t count,
        std::optional<std::span<const std::uint32_t>> among = {}, int jobs = 1) const;

    /// The sketch of one model.
    [[nodiscard]] ScanRow row(std::uint32_t index) const;

private:
    /// Distances of signatures; as long as `among`, or as the collection.
    [[nodiscard]] std::vector<std::uint16_t> distances(
        std::span<const std::uint8_t> query, std::optional<std::span<const std::uint32_t>> among,
        int jobs) const;
    [[nodiscard]] std::size_t block_of(std::uint32_t index) const;

    std::vector<const ScanRows*> blocks_;
    std::vector<std::size_t> first_;  ///< model of each block, and of one after the last
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
    // Models that pass each stage; 0 = as many as `with_widths` says.
    std::size_t by_signature = 0;  ///< of the collection, by signatures
    std::size_t by_sketch = 0;     ///< of those, by sketches: the finalists
    /// Indices of the models that may be hits, ascending; all without. The scan and what follows
    /// look at no other, and each model is at the same distance as without it, except with
    /// `rerank`, where all places are found first.
    std::optional<std::span<const std::uint32_t>> among = {};
};

/// The options with the widths of the stages that a collection of so many models is searched by,
/// where they say none; wide enough for the number of models that are wanted.
[[nodiscard]] NearestOptions with_widths(NearestOptions nearest, std::size_t models);

/// The nearest models of a large collection, nearest first, equal distances by index: a scan of all
/// signatures, the sketches of what is left, then the ranker's own distance of the finalists, bit
/// by bit that of rank_distances. Where many models are wanted there are four finalists for each at
/// least. The thesis' `chain-code`, parts, more than a quarter of a collection wanted, and small
/// collections are measured exhaustively, by blocks of models. With `rerank` the nearest 200
/// finalists change places among themselves. Models that are not there any more are no hits.
/// Errors: cancelled, those of the source.
/// @param preselection  of the source's collection
Result<std::vector<RankedModel>> nearest_models(const descriptor::ModelDescriptor& query,
                                                DescriptorSource& collection,
                                                const Preselection& preselection,
                                                const Normalization& normalization,
                                                const RankOptions& options,
                                                const NearestOptions& nearest = {});

/// Whether a search of these options measures every model of a collection of that size.
[[nodiscard]] bool measures_all(std::size_t models, const RankOptions& options,
                                const NearestOptions& nearest = {});

}  // namespace ossuary::ranking
