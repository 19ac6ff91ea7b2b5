#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "index/cli/command.h"
#include "index/cli/options.h"
#include "index/indexer.h"
#include "index/model.h"

namespace ossuary::cli {

/// What is indexed, and how: the options that `index` and `watch` have in common.
struct IndexArguments {
    std::string index_path;
    std::string classes_path;
    std::vector<std::string> paths;
    PipelineOptions pipeline;
    VolumeOptions volume;
    std::vector<std::string> exclude;
    std::string up = "auto";
    bool split = false;
    double model_timeout_seconds = index::IndexOptions{}.model_timeout_seconds;

    void add_to(CLI::App& command);
    /// What the user leaves open is as in the index that is there. Errors: invalid_argument.
    [[nodiscard]] Result<index::IndexParameters> parameters() const;
    /// Errors: invalid_argument, those of read_classification.
    [[nodiscard]] Result<index::IndexOptions> options(const Session& session) const;
};

/// "3 indexed, 1 moved": what was done to the models.
[[nodiscard]] std::string outcome_text(const index::IndexOutcome& outcome);

/// Says on stderr what was asked for and not done, since it may be a mistake.
void print_refusals(const std::vector<index::PruneRefusal>& refusals, const Session& session);

}  // namespace ossuary::cli
