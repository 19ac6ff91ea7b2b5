#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/preselection.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/describe_model.h"
#include "index/presentation.h"
#include "index/searcher.h"

namespace ossuary::cli {
namespace {

struct SearchArguments {
    std::string index_path;
    std::string model_path;
    std::size_t limit = index::SearchOptions{}.limit;
    std::string class_filter;
    VolumeOptions volume;
    RankingOptions ranking;
};

/// Of the hits of a part, how large it is there and how much of it lies on the hit.
std::pair<std::string, std::string> placement_text(const index::Hit& hit) {
    if (!hit.placement) return {"-", "-"};
    return {fmt::format("{:.4g}", hit.placement->placement.scale),
            fmt::format("{:.0f} %", 100.0 * hit.placement->explained)};
}

void print_hits(const index::SearchResult& result, bool part) {
    std::vector<Table::Column> columns{
        {"rank", Align::kRight},          {"distance", Align::kRight}, {"name"}, {"class"},
        {"matched nodes", Align::kRight}, {"id", Align::kRight}};
    if (part) {
        columns.push_back({"scale", Align::kRight});
        columns.push_back({"in place", Align::kRight});
    }
    Table table(std::move(columns));
    for (const index::Hit& hit : result.hits) {
        std::vector<std::string> row{std::to_string(hit.rank),
                                     fmt::format("{:.4f}", hit.distance),
                                     hit.name,
                                     hit.class_name.empty() ? "-" : hit.class_name,
                                     std::to_string(hit.matched_nodes),
                                     fmt::format("#{}", hit.id)};
        if (part) {
            auto [scale, in_place] = placement_text(hit);
            row.push_back(std::move(scale));
            row.push_back(std::move(in_place));
        }
        table.add_row(std::move(row));
    }
    std::cout << table.text();
    std::cerr << terminal_format("{} of {} models in {:.0f} ms\n", result.hits.size(),
                                 result.models, result.took_ms);
}

/// A search that measures every model of a large collection says so beforehand.
void say_what_all_costs(std::size_t models, const ranking::RankOptions& rank, std::size_t limit) {
    const ranking::NearestOptions nearest{.count = limit == 0 ? models : limit};
    if (models <= nearest.exhaustive_below || !ranking::measures_all(models, rank, nearest)) return;
    // Of one model on one core: reading its descriptor and matching it, or for a part reading the
    // features of its surface and comparing them.
    constexpr double kPairMs = 0.5, kFeaturesMs = 1.5;
    const double seconds = static_cast<double>(models) * (rank.part ? kFeaturesMs : kPairMs) /
                           1000.0 / resolve_jobs(rank.jobs);
    std::cerr << terminal_format("every one of {} models is measured for this: some {:.0f} s\n",
                                 models, seconds);
}

Result<ExitCode> run(const SearchArguments& options, const Session& session) {
    const Result<std::vector<ranking::RankOptions>> rank =
        options.ranking.rank_options(session.jobs);
    if (!rank.ok()) return rank.error();
    Result<index::Searcher> searcher = index::Searcher::open(options.index_path);
    if (!searcher.ok()) return searcher.error();
    // Opening the index is not part of the answer's time; a server does it once.
    const auto snapshot = searcher->snapshot();
    if (!snapshot.ok()) return snapshot.error();
    say_what_all_costs((*snapshot)->size(), rank->front(), options.limit);

    Stopwatch watch;
    const Result<mesh::ReadMeshResult> query =
        session.reader->read(options.model_path, options.volume.read_options(), session.stop);
    if (!query.ok()) return query.error();
    const double read_ms = watch.elapsed_ms();

    index::SearchOptions search;
    search.rank = rank->front();
    search.limit = options.limit;
    search.class_filter = options.class_filter;
    Result<index::SearchResult> result = searcher->search(query->mesh, search, session.stop);
    if (!result.ok()) return result.error();
    result->took_ms += read_ms;
    result->stages_ms.insert(result->stages_ms.begin(), {"read", read_ms});
    result->warnings.insert(result->warnings.begin(), query->warnings.begin(),
                            query->warnings.end());

    if (session.json) {
        index::QueryDescription description;
        description.name = std::filesystem::path(options.model_path).stem().string();
        description.vertices = query->mesh.vertices.size();
        description.faces = query->mesh.face_count;
        description.frame = index::frame_of(*query);
        description.up = description.frame.up;
        print_json(index::to_json(*result, description, search.rank));
    } else {
        print_hits(*result, search.rank.part);
    }
    return ExitCode::kDone;
}

}  // namespace

void add_search(CLI::App& app, Session& session) {
    auto options = std::make_shared<SearchArguments>();
    CLI::App* command =
        app.add_subcommand("search", "Find the models of an index that resemble a model file");
    add_index_option(*command, options->index_path);
    command->add_option("MODEL", options->model_path, "The query: a model file")->required();
    command->add_option("--limit", options->limit, "How many hits (0 = all)")
        ->capture_default_str();
    command->add_option("--class", options->class_filter, "Only hits of this class");
    options->volume.add_to(*command);
    options->ranking.add_to(*command, RankingOptions::Count::kOne, true);
    options->ranking.add_part_to(*command,
                                 "Find models that have the query as a part: an arm finds people");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
