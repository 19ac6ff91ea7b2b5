#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/presentation.h"
#include "index/unit.h"

namespace ossuary::cli {
namespace {

struct ShowArguments {
    std::string index_path;
    std::string model;
};

Result<ExitCode> show_index(index::Store& store, const Session& session) {
    index::ModelFilter nothing_but_the_count;
    nothing_but_the_count.limit = 1;
    const Result<index::ModelPage> page = store.models(nothing_but_the_count);
    if (!page.ok()) return page.error();
    const Result<std::vector<index::Failure>> failures = store.failures();
    if (!failures.ok()) return failures.error();
    if (session.json) {
        nlohmann::json list = nlohmann::json::array();
        for (const auto& failure : *failures) list.push_back(index::to_json(failure));
        print_json({{"index", store.path().string()},
                    {"version", store.version()},
                    {"revision", page->revision},
                    {"parameters", index::to_json(store.parameters())},
                    {"models", page->total},
                    {"failures", std::move(list)}});
        return ExitCode::kDone;
    }
    const index::IndexParameters& parameters = store.parameters();
    std::cout << terminal_format(
        "{}: {} models, {} failures, revision {}\nresolution {}, thinning {}, pipeline {}, "
        "format {}\n",
        store.path().string(), page->total, failures->size(), page->revision, parameters.resolution,
        to_string(parameters.thinning), parameters.pipeline, store.version());
    for (const index::Failure& failure : *failures) {
        std::cout << terminal_format("failed: {}: {}: {}\n", failure.path, failure.code,
                                     failure.message);
    }
    return ExitCode::kDone;
}

void print_model(const index::ModelSummary& model, const index::StoredSkeleton& skeleton) {
    const Vec3 extent = model.bounds.sizes();
    const std::string unit = index::unit_name(model.frame.metres_per_unit);
    std::cout << terminal_format(
        "#{} {}\nclass         {}\npath          {}\nvertices      {}\nfaces         {}\n"
        "size          {:.6g} x {:.6g} x {:.6g}{}\nup            {} ({})\nsurface area  {:.6g}\n"
        "indexed at    {}\n",
        model.id, model.name, model.class_name.empty() ? "-" : model.class_name,
        model.path.empty() ? "-" : model.path, model.vertices, model.faces, extent.x(), extent.y(),
        extent.z(), unit.empty() ? " (no unit)" : " " + unit, to_string(model.orientation.up),
        model.orientation.said_by_person         ? "as was said"
        : model.frame.up == model.orientation.up ? "as the file says"
                                                 : "found",
        model.surface_area, model.indexed_at);
    for (const mesh::MeshWarning& warning : model.warnings) {
        std::cout << terminal_format("warning       {}: {}\n", warning.code, warning.message);
    }
    Table table({{"branch", Align::kRight}, {"nodes"}, {"length", Align::kRight}, {"chain code"}});
    for (std::size_t b = 0; b < skeleton.graph.branches.size(); ++b) {
        const skeleton::SkeletonGraph::Branch& branch = skeleton.graph.branches[b];
        table.add_row({std::to_string(b), fmt::format("{}-{}", branch.a, branch.b),
                       fmt::format("{:.4g}", branch.length()), skeleton.chain_codes[b]});
    }
    std::cout << terminal_format("skeleton      {} nodes, {} branches\n",
                                 skeleton.graph.nodes.size(), skeleton.graph.branches.size())
              << table.text();
}

Result<ExitCode> show_model(index::Store& store, const std::string& text, const Session& session) {
    const Result<index::ModelSummary> model = find_model(store, text);
    if (!model.ok()) return model.error();
    const Result<index::StoredSkeleton> skeleton = store.skeleton(model->id);
    if (!skeleton.ok()) return skeleton.error();
    if (session.json) {
        nlohmann::json document = index::to_json(*model);
        document["skeleton"] = index::to_json(*skeleton);
        print_json(document);
    } else {
        print_model(*model, *skeleton);
    }
    return ExitCode::kDone;
}

Result<ExitCode> run(const ShowArguments& options, const Session& session) {
    Result<index::Store> store = index::Store::open(options.index_path, index::Access::kReadOnly);
    if (!store.ok()) return store.error();
    return options.model.empty() ? show_index(*store, session)
                                 : show_model(*store, options.model, session);
}

}  // namespace

void add_show(CLI::App& app, Session& session) {
    auto options = std::make_shared<ShowArguments>();
    CLI::App* command = app.add_subcommand(
        "show", "Show an index (parameters, failures) or one model with its chain codes");
    add_index_option(*command, options->index_path);
    command->add_option("MODEL", options->model, "A model's name or #id");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
