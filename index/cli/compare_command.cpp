#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "engine/mesh/read_mesh.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/presentation.h"
#include "index/searcher.h"

namespace ossuary::cli {
namespace {

struct CompareArguments {
    std::string a, b;
    std::string index_path;
    PipelineOptions pipeline;
    VolumeOptions volume;
    RankingOptions ranking;
};

Result<index::Comparison> compare_files(const CompareArguments& options,
                                        const ranking::RankOptions& rank, const Session& session) {
    const Result<index::IndexParameters> parameters = options.pipeline.parameters();
    if (!parameters.ok()) return parameters.error();
    const voxel::ReadModelOptions reading = options.volume.read_options();
    const Result<mesh::ReadMeshResult> a = session.reader->read(options.a, reading, session.stop);
    if (!a.ok()) return a.error();
    const Result<mesh::ReadMeshResult> b = session.reader->read(options.b, reading, session.stop);
    if (!b.ok()) return b.error();
    Result<index::Comparison> comparison =
        index::compare_meshes(a->mesh, b->mesh, *parameters, rank, session.stop);
    if (!comparison.ok()) return comparison.error();
    comparison->a.summary.name = std::filesystem::path(options.a).stem().string();
    comparison->b.summary.name = std::filesystem::path(options.b).stem().string();
    return comparison;
}

Result<index::Comparison> compare_indexed(const CompareArguments& options,
                                          const ranking::RankOptions& rank) {
    Result<index::Searcher> searcher = index::Searcher::open(options.index_path);
    if (!searcher.ok()) return searcher.error();
    const Result<index::ModelSummary> a = find_model(searcher->store(), options.a);
    if (!a.ok()) return a.error();
    const Result<index::ModelSummary> b = find_model(searcher->store(), options.b);
    if (!b.ok()) return b.error();
    return searcher->compare(a->id, b->id, rank);
}

void print_comparison(const index::Comparison& comparison) {
    const matching::Match& match = comparison.match;
    std::cout << terminal_format("distance {:.4f}\n", match.distance);
    for (const matching::DistancePart& part : match.parts) {
        std::cout << terminal_format("  {:<28} {:.4f}\n", part.name, part.value);
    }
    std::string clusters;
    for (const std::uint32_t size : match.correspondence.cluster_sizes) {
        clusters += fmt::format("{}{}", clusters.empty() ? " in clusters of " : ", ", size);
    }
    std::cout << terminal_format("{} matched nodes{}\n", match.correspondence.nodes.size(),
                                 clusters);
    if (match.correspondence.branches.empty()) return;
    Table table({{comparison.a.summary.name + " branch", Align::kRight},
                 {comparison.b.summary.name + " branch", Align::kRight},
                 {"cost", Align::kRight}});
    for (const auto& pair : match.correspondence.branches) {
        table.add_row(
            {std::to_string(pair.a), std::to_string(pair.b), fmt::format("{:.4f}", pair.cost)});
    }
    std::cout << table.text();
}

Result<ExitCode> run(const CompareArguments& options, const Session& session) {
    const Result<std::vector<ranking::RankOptions>> rank =
        options.ranking.rank_options(session.jobs);
    if (!rank.ok()) return rank.error();
    const Result<index::Comparison> comparison =
        options.index_path.empty() ? compare_files(options, rank->front(), session)
                                   : compare_indexed(options, rank->front());
    if (!comparison.ok()) return comparison.error();
    if (session.json) {
        print_json(index::to_json(*comparison, rank->front()));
    } else {
        print_comparison(*comparison);
    }
    return ExitCode::kDone;
}

}  // namespace

void add_compare(CLI::App& app, Session& session) {
    auto options = std::make_shared<CompareArguments>();
    CLI::App* command =
        app.add_subcommand("compare", "Distance of two models, its parts and correspondences");
    command->add_option("A", options->a, "A model file, or with --index a model's name or #id")
        ->required();
    command->add_option("B", options->b, "The other one")->required();
    command
        ->add_option("--index", options->index_path,
                     "Compare two models of this index, normalised by its statistics")
        ->type_name("FILE");
    options->pipeline.add_to(*command);
    options->volume.add_to(*command);
    options->ranking.add_to(*command, RankingOptions::Count::kOne, false);
    options->ranking.add_part_to(*command, "How far B is from having A as a part");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
