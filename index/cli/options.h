#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/ranker.h"
#include "engine/voxel/read_model.h"
#include "index/model.h"
#include "index/store.h"
#include "index/up.h"

namespace ossuary::cli {

/// --resolution and --thinning: how a model becomes a skeleton.
struct PipelineOptions {
    int resolution = index::IndexParameters{}.resolution;
    std::string thinning = "anchored";
    CLI::Option* resolution_option = nullptr;
    CLI::Option* thinning_option = nullptr;

    void add_to(CLI::App& command);
    /// `defaults` with what the user named replaced.
    [[nodiscard]] Result<index::IndexParameters> parameters(
        const index::IndexParameters& defaults = {}) const;
};

/// --threshold and --label: what of a volume is the model.
struct VolumeOptions {
    voxel::InsideOptions inside;

    void add_to(CLI::App& command);
    [[nodiscard]] voxel::ReadModelOptions read_options() const { return {.inside = inside}; }
};

/// --ranker, --pose, --size, --rerank and --part.
struct RankingOptions {
    std::vector<std::string> rankers = {"hybrid"};
    double pose = ranking::RankOptions{}.pose;
    double size = ranking::RankOptions{}.size;
    bool rerank = false;
    bool part = false;

    enum class Count { kOne, kSeveral };
    void add_to(CLI::App& command, Count count, bool with_rerank);
    /// @param help  what it means here
    void add_part_to(CLI::App& command, const std::string& help);
    /// One set of options for each ranker named.
    [[nodiscard]] Result<std::vector<ranking::RankOptions>> rank_options(int jobs) const;
};

/// y, z, or none for `auto`. Errors: invalid_argument.
Result<std::optional<index::Up>> parse_up_or_auto(const std::string& text);

/// Adds the required option --index.
void add_index_option(CLI::App& command, std::string& index_path);

/// The models that `text` names: `#7` is the id 7; anything else is a name, and if no model has it
/// and it is a number, an id; last, a name as lists show it. Errors: model_not_found.
Result<std::vector<index::ModelSummary>> find_models(index::Store& store, const std::string& text);

/// Like find_models, for commands that mean exactly one. Errors: also invalid_argument when several
/// models have the name; the message lists their ids.
Result<index::ModelSummary> find_model(index::Store& store, const std::string& text);

/// What `texts` name, each model once: exactly one model each, or with `all_of_name` every one of a
/// name. Errors: those of find_model.
Result<std::vector<index::ModelSummary>> choose_models(index::Store& store,
                                                       const std::vector<std::string>& texts,
                                                       bool all_of_name);

}  // namespace ossuary::cli
