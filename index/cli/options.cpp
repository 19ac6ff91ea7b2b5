#include "index/cli/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "engine/core/text.h"
#include "engine/skeleton/thinning.h"

namespace ossuary::cli {
namespace {

std::optional<index::ModelId> parse_id(std::string_view text) {
    index::ModelId id = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return id;
}

Result<std::vector<index::ModelSummary>> only(Result<index::ModelSummary> model) {
    if (!model.ok()) return model.error();
    return std::vector{*std::move(model)};
}

/// Models whose name is shown as `text`, in JSON or on a terminal, without being spelled so.
Result<std::vector<index::ModelSummary>> find_models_shown_as(index::Store& store,
                                                              const std::string& text) {
    index::ModelFilter everything;
    everything.limit = 0;
    Result<index::ModelPage> page = store.models(everything);
    if (!page.ok()) return page.error();
    std::erase_if(page->models, [&](const index::ModelSummary& model) {
        return valid_utf8(model.name) != text && terminal_text(model.name) != text;
    });
    return std::move(page->models);
}

}  // namespace

void PipelineOptions::add_to(CLI::App& command) {
    resolution_option =
        command.add_option("--resolution", resolution, "Voxels along the longest side of a model")
            ->check(CLI::Range(8, 1024))
            ->capture_default_str();
    thinning_option = command
                          .add_option("--thinning", thinning,
                                      "Thinning method: anchored (ours) or parallel (the thesis')")
                          ->check(CLI::IsMember({"anchored", "parallel"}))
                          ->capture_default_str();
}

Result<index::IndexParameters> PipelineOptions::parameters(
    const index::IndexParameters& defaults) const {
    index::IndexParameters parameters = defaults;
    if (resolution_option->count() > 0) parameters.resolution = resolution;
    if (thinning_option->count() > 0) {
        const Result<skeleton::ThinningMethod> method = skeleton::parse_thinning_method(thinning);
        if (!method.ok()) return method.error();
        parameters.thinning = *method;
    }
    return parameters;
}

void VolumeOptions::add_to(CLI::App& command) {
    const CLI::Validator finite(
        [](const std::string& text) {
            double value = 0.0;
            const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
            return is_number ? std::string() : "expected a finite number, found " + text;
        },
        "NUMBER", "finite");
    CLI::Option* threshold =
        command
            .add_option("--threshold", inside.threshold,
                        "Of volumes (NRRD, NIfTI, binvox, .npy): values of at least this are the "
                        "model; other files have no use for it (default: found from the values)")
            ->check(finite);
    command.add_option("--label", inside.label, "Of volumes: this value alone is the model")
        ->check(finite)
        ->excludes(threshold);
}

void RankingOptions::add_to(CLI::App& command, Count count, bool with_rerank) {
    CLI::Option* ranker = command.add_option("--ranker", rankers, "hybrid, skeleton or chain-code")
                              ->check(CLI::IsMember({"hybrid", "skeleton", "chain-code"}))
                              ->capture_default_str();
    if (count == Count::kOne) {
        ranker->expected(1);
    } else {
        ranker->expected(1, 3)->delimiter(',');
    }
    command
        .add_option("--pose", pose,
                    "0 = how it is built alone, 1 = how it stands alone; the default tells kinds "
                    "apart best")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    command
        .add_option("--size", size,
                    "How far the size counts, for models that are all in one unit: 0 = not at all")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    if (with_rerank) {
        command.add_flag("--rerank", rerank, "Re-rank by the neighbourhoods within the collection");
    }
}

void RankingOptions::add_part_to(CLI::App& command, const std::string& help) {
    CLI::Option* option = command.add_flag("--part", part, help);
    for (const char* other : {"--ranker", "--rerank"}) {
        if (CLI::Option* found = command.get_option_no_throw(other)) option->excludes(found);
    }
}

Result<std::vector<ranking::RankOptions>> RankingOptions::rank_options(int jobs) const {
    std::vector<ranking::RankOptions> all;
    for (const std::string& name : rankers) {
        const Result<ranking::RankerKind> ranker = ranking::parse_ranker(name);
        if (!ranker.ok()) return ranker.error();
        ranking::RankOptions options;
        options.ranker = *ranker;
        options.pose = pose;
        options.size = size;
        options.rerank = rerank;
        options.part = part;
        options.jobs = jobs;
        all.push_back(options);
    }
    return all;
}

Result<std::optional<index::Up>> parse_up_or_auto(const std::string& text) {
    if (text == "auto") return std::optional<index::Up>();
    const Result<index::Up> up = index::parse_up(text);
    if (!up.ok()) return {up.error().code, up.error().message + ", or auto"};
    return std::optional(*up);
}

void add_index_option(CLI::App& command, std::string& index_path) {
    command.add_option("--index", index_path, "The index file")->required()->type_name("FILE");
}

Result<std::vector<index::ModelSummary>> find_models(index::Store& store, const std::string& text) {
    if (text.starts_with('#')) {
        const auto id = parse_id(std::string_view(text).substr(1));
        if (!id) return {ErrorCode::kModelNotFound, fmt::format("'{}' is no model id", text)};
        return only(store.model(*id));
    }
    Result<std::vector<index::ModelSummary>> named = store.models_named(text);
    if (!named.ok() || !named->empty()) return named;
    if (const auto id = parse_id(text)) return only(store.model(*id));
    Result<std::vector<index::ModelSummary>> shown = find_models_shown_as(store, text);
    if (!shown.ok() || !shown->empty()) return shown;
    return {ErrorCode::kModelNotFound, fmt::format("no model is named '{}'", text)};
}

Result<index::ModelSummary> find_model(index::Store& store, const std::string& text) {
    Result<std::vector<index::ModelSummary>> models = find_models(store, text);
    if (!models.ok()) return models.error();
    if (models->size() > 1) {
        std::string ids;
        for (const auto& model : *models) ids += fmt::format(" '#{}'", model.id);
        return {ErrorCode::kInvalidArgument,
                fmt::format("{} models are named '{}': name one by its id:{}", models->size(), text,
                            ids)};
    }
    return models->front();
}

Result<std::vector<index::ModelSummary>> choose_models(index::Store& store,
                                                       const std::vector<std::string>& texts,
                                                       bool all_of_name) {
    std::vector<index::ModelSummary> models;
    for (const std::string& text : texts) {
        const auto named = all_of_name ? find_models(store, text) : only(find_model(store, text));
        if (!named.ok()) return named.error();
        for (const index::ModelSummary& model : *named) {
            const auto same = [&](const auto& other) { return other.id == model.id; };
            if (std::none_of(models.begin(), models.end(), same)) models.push_back(model);
        }
    }
    return models;
}

}  // namespace ossuary::cli
