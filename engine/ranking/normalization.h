#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/ranking/descriptor_source.h"
#include "engine/ranking/pair_distances.h"

namespace ossuary::ranking {

/// How far other models typically are from one, in each component: what its distances are judged
/// by, so that components of different units can be added and a model that is near to everything
/// does not come up everywhere.
struct ModelScale {
    ComponentValues mean{};
    ComponentValues deviation{};  ///< standard deviation, above 0
};

/// CollectionStatistics, read: the scale of each model that it knows and of all together.
///
/// Collections of up to 20,000 models know each of their models; what larger ones or other queries
/// need is estimated from the pooled scale. Layout of `values`: format, number of components,
/// number of models that the statistics are of, the pooled scale, then for each known model the two
/// halves of its key and its scale; a scale is the means of all components, then the deviations.
class Normalization {
public:
    /// Statistics that are empty or of another format leave the built-in scale.
    explicit Normalization(const CollectionStatistics& statistics = {});

    /// The model's own scale where the statistics know it, else null.
    [[nodiscard]] const ModelScale* find(const descriptor::ModelDescriptor& model) const;
    /// The same by model_key.
    [[nodiscard]] const ModelScale* find(std::uint64_t key) const;
    [[nodiscard]] const ModelScale& pooled() const { return pooled_; }
    /// Models that the statistics are of.
    [[nodiscard]] std::size_t collection_size() const { return collection_size_; }

    /// Own scale or the pooled one.
    [[nodiscard]] const ModelScale& scale(const descriptor::ModelDescriptor& model) const {
        const ModelScale* own = find(model);
        return own != nullptr ? *own : pooled_;
    }

private:
    ModelScale pooled_;
    std::size_t collection_size_ = 0;
    std::unordered_map<std::uint64_t, ModelScale> known_;
};

/// What statistics know a model by: a hash of its signature and of its skeleton, which every part
/// of a descriptor has a share in.
[[nodiscard]] std::uint64_t model_key(const descriptor::ModelDescriptor& model);

/// The same as for descriptors in memory (ranker.h), of which few are in use at a time here: those
/// of the references and of a block of others. Models that are not there any more do not count.
/// Errors: cancelled, those of the source.
Result<CollectionStatistics> collection_statistics(DescriptorSource& collection, int jobs = 1,
                                                   const std::stop_token& stop = {});

/// Indices of the models that others are judged by, ascending: all of a small collection, else
/// evenly spread over it, at most 500.
[[nodiscard]] std::vector<std::size_t> reference_models(std::size_t count);

/// Of those, the models that one query is judged by which the statistics do not know: fewer where
/// not every model is measured anyway.
[[nodiscard]] std::vector<std::size_t> judging_models(std::size_t count);

/// The scale of a query that the statistics do not know, from its distances to the judging models;
/// leans on the pooled scale where there are few.
[[nodiscard]] ModelScale scale_of_row(const std::vector<ComponentValues>& distances,
                                      const ModelScale& pooled);

}  // namespace ossuary::ranking
