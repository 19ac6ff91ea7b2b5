#include "index/evaluation.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <map>
#include <random>

#include "engine/core/whole_file.h"
#include "index/content_hash.h"
#include "index/descriptor_cache.h"
#include "index/timestamp.h"

namespace ossuary::index {

namespace {

using Selection = ClassifiedModels;

std::string file_name(const CatalogueEntry& model) {
    return model.path.empty() ? std::string(model.name)
                              : std::filesystem::path(model.path).filename().string();
}

Selection select_classified(const Snapshot& snapshot) {
    Selection selection;
    snapshot.for_each_block([&](const ScanBlock& block, std::size_t first) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (block.class_name(i).empty()) continue;
            selection.positions.push_back(first + i);
            selection.labels.emplace_back(block.class_name(i));
        }
    });
    return selection;
}

Result<Selection> select(const Snapshot& snapshot, StorePool& stores,
                         const EvaluateOptions& options) {
    if (!(options.rank.pose >= 0.0 && options.rank.pose <= 1.0)) {
        return {ErrorCode::kInvalidArgument,
                "pose: " + std::to_string(options.rank.pose) + ", expected a number from 0 to 1"};
    }
    auto selection = options.classification
                         ? classified_models(snapshot, stores, *options.classification)
                         : Result<Selection>(select_classified(snapshot));
    if (!selection) return selection;
    std::map<std::string, int> members;
    for (const std::string& label : selection->labels) ++members[label];
    const bool usable = std::any_of(members.begin(), members.end(),
                                    [](const auto& one) { return one.second >= 2; });
    if (!usable) {
        return {ErrorCode::kInvalidArgument, "nothing to evaluate: of " +
                                                 std::to_string(selection->labels.size()) +
                                                 " models with a class no two are of the same"};
    }
    return selection;
}

/// Tells evaluated collections of one revision apart.
std::string collection_hash(const Snapshot& snapshot, const Selection& selection,
                            std::size_t sample) {
    std::string text = sample == 0 ? "" : "sample " + std::to_string(sample) + '\n';
    for (std::size_t i = 0; i < selection.positions.size(); ++i) {
        text += std::to_string(snapshot.id(selection.positions[i]));
        text += ' ';
        text += selection.labels[i];
        text += '\n';
    }
    return content_hash(text);
}

Evaluation frame(const Snapshot& snapshot, const Selection& selection,
                 const ranking::RankOptions& rank) {
    Evaluation evaluation;
    evaluation.ranker = rank.ranker;
    evaluation.rerank = rank.rerank;
    evaluation.pose = rank.pose;
    for (const std::size_t position : selection.positions) {
        evaluation.order.push_back(snapshot.id(position));
    }
    evaluation.labels = selection.labels;
    evaluation.missing = selection.missing;
    evaluation.queries = ranking::retrieval_queries(selection.labels).size();
    evaluation.revision = snapshot.revision();
    return evaluation;
}

/// The statistics of just the evaluated models, as if nothing else were in the index.
Result<ranking::CollectionStatistics> statistics_for(const Snapshot& snapshot,
                                                     const Selection& selection,
                                                     ranking::DescriptorSpan descriptors,
                                                     const ranking::RankOptions& rank) {
    if (rank.ranker == ranking::RankerKind::kChainCode) return ranking::CollectionStatistics{};
    bool whole = selection.positions.size() == snapshot.size();
    for (std::size_t i = 0; whole && i < selection.positions.size(); ++i) {
        whole = selection.positions[i] == i;
    }
    if (whole && snapshot.state().statistics == snapshot.revision()) return snapshot.statistics();
    return ranking::collection_statistics(descriptors, rank.jobs, rank.stop);
}

/// How many queries are drawn; 0 where all are searched with.
std::size_t sample_of(const Selection& selection, const EvaluateOptions& options) {
    const std::size_t queries = ranking::retrieval_queries(selection.labels).size();
    return options.sample < queries ? options.sample : 0;
}

/// So many of the queries, each subset as likely as any other (Knuth, "The Art of Computer
/// Programming" 2, sec. 3.4.2, algorithm S), the same on every machine.
std::vector<std::size_t> drawn_queries(const std::vector<std::string>& labels, std::size_t count) {
    constexpr std::uint64_t kSeed = 0x05507A27;
    const std::vector<std::size_t> queries = ranking::retrieval_queries(labels);
    std::mt19937_64 random(kSeed);
    std::vector<std::size_t> drawn;
    for (std::size_t i = 0; i < queries.size() && drawn.size() < count; ++i) {
        const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
        const auto left = static_cast<double>(queries.size() - i);
        if (unit * left < static_cast<double>(count - drawn.size())) drawn.push_back(queries[i]);
    }
    return drawn;
}

Result<ranking::RetrievalReport> sampled_report(ranking::DescriptorSpan descriptors,
                                                const std::vector<std::string>& labels,
                                                const ranking::CollectionStatistics& statistics,
                                                const ranking::RankOptions& rank,
                                                std::size_t sample) {
    std::vector<ranking::QueryDistances> rows;
    for (const std::size_t query : drawn_queries(labels, sample)) {
        const auto distances =
            ranking::rank_distances(*descriptors[query], descriptors, statistics, rank);
        if (!distances) return distances.error();
        rows.push_back({query, {distances->begin(), distances->end()}});
    }
    return ranking::evaluate_queries(rows, labels);
}

Result<Evaluation> compute(const Snapshot& snapshot, StorePool& stores, const Selection& selection,
                           const EvaluateOptions& options) {
    const ranking::RankOptions& rank = options.rank;
    const auto loaded = load_descriptors(snapshot, stores, selection.positions, rank.jobs);
    if (!loaded) return loaded.error();
    std::vector<const descriptor::ModelDescriptor*> descriptors;
    for (const ranking::SharedDescriptor& model : *loaded) descriptors.push_back(model.get());
    const auto statistics = statistics_for(snapshot, selection, descriptors, rank);
    if (!statistics) return statistics.error();
    Evaluation evaluation = frame(snapshot, selection, rank);
    if (const std::size_t sample = sample_of(selection, options); sample > 0) {
        auto report = sampled_report(descriptors, selection.labels, *statistics, rank, sample);
        if (!report) return report.error();
        evaluation.report = *std::move(report);
    } else {
        auto distances = ranking::distance_matrix(descriptors, *statistics, rank);
        if (!distances) return distances.error();
        evaluation.distances = *std::move(distances);
        evaluation.report = evaluate_retrieval(evaluation.distances, evaluation.labels);
    }
    evaluation.computed_at = utc_now();
    return evaluation;
}

}  // namespace

Result<std::vector<ranking::SharedDescriptor>> load_descriptors(
    const Snapshot& snapshot, StorePool& stores, std::span<const std::size_t> positions, int jobs) {
    SnapshotDescriptors source(snapshot, stores, nullptr, jobs);
    const std::vector<std::uint32_t> wanted(positions.begin(), positions.end());
    auto loaded = source.fetch(wanted);
    if (loaded && source.missed()) {
        return {ErrorCode::kIndexBusy, "the index changes while its models are read; try again"};
    }
    return loaded;
}

Result<ClassifiedModels> classified_models(const Snapshot& snapshot, StorePool& stores,
                                           const ranking::Classification& classification) {
    const auto store = stores.lend();
    if (!store) return store.error();
    const auto catalogue = snapshot.catalogue(**store);
    if (!catalogue) return catalogue.error();
    const Catalogue& models = **catalogue;
    std::multimap<std::string, std::size_t> by_file_name;
    for (std::size_t i = 0; i < models.size(); ++i) by_file_name.emplace(file_name(models[i]), i);
    ClassifiedModels selection;
    for (const ranking::ClassifiedModel& named : ranking::models_in_order(classification)) {
        std::optional<std::size_t> position;
        for (const std::string& name : ranking::candidate_file_names(named.id)) {
            const auto [first, last] = by_file_name.equal_range(name);
            if (first == last) continue;
            if (std::next(first) != last) {
                return {ErrorCode::kInvalidArgument,
                        "model \"" + named.id + "\" may be " +
                            std::string(models[first->second].path) + " or " +
                            std::string(models[std::next(first)->second].path)};
            }
            position = first->second;
            break;
        }
        if (position) {
            selection.positions.push_back(*position);
            selection.labels.push_back(named.class_name);
        } else {
            selection.missing.push_back(named.id);
        }
    }
    if (selection.positions.empty() && !selection.missing.empty()) {
        return {ErrorCode::kClaUnknownModel,
                "none of the " + std::to_string(selection.missing.size()) +
                    " models that the classification names is in the index, the first being \"" +
                    selection.missing.front() + "\""};
    }
    return selection;
}

Result<Evaluation> evaluate(const Snapshot& snapshot, StorePool& stores,
                            const EvaluateOptions& options) {
    const auto selection = select(snapshot, stores, options);
    if (!selection) return selection.error();
    return compute(snapshot, stores, *selection, options);
}

Result<Evaluation> evaluate_cached(Store& store, const Snapshot& snapshot, StorePool& stores,
                                   const EvaluateOptions& options) {
    const auto selection = select(snapshot, stores, options);
    if (!selection) return selection.error();
    const EvaluationKey key{snapshot.revision(),
                            options.rank.ranker,
                            options.rank.rerank,
                            options.rank.pose,
                            collection_hash(snapshot, *selection, sample_of(*selection, options)),
                            snapshot.state().replacements};
    auto cached = store.evaluation(key);
    if (!cached) return cached.error();
    if (*cached) {
        Evaluation evaluation = frame(snapshot, *selection, options.rank);
        evaluation.report = std::move((*cached)->report);
        evaluation.computed_at = std::move((*cached)->computed_at);
        return evaluation;
    }
    auto evaluation = compute(snapshot, stores, *selection, options);
    if (!evaluation) return evaluation;
    // A reader cannot keep it, and whoever writes for long should not fail a reader.
    const auto kept = store.put_evaluation(key, evaluation->report);
    if (!kept && kept.error().code != ErrorCode::kIndexIo &&
        kept.error().code != ErrorCode::kIndexBusy &&
        kept.error().code != ErrorCode::kIndexReplaced) {
        return kept.error();
    }
    return evaluation;
}

Result<void> write_matrix(const std::filesystem::path& path,
                          const ranking::DistanceMatrix& distances) {
    assert(distances.values.size() == distances.size * distances.size);
    std::string bytes;
    bytes.reserve(distances.values.size() * sizeof(float));
    for (const float value : distances.values) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift);
    }
    return write_whole_file(path, bytes);
}

}  // namespace ossuary::index
