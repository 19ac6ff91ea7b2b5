#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/indexer.h"

namespace ossuary::cli {
namespace {

struct RemoveArguments {
    std::string index_path;
    std::vector<std::string> models;
    bool all_of_name = false;
};

// All that are named go in one transaction, or none: one wrong name removes nothing.
Result<ExitCode> run(const RemoveArguments& options, const Session& session) {
    Result<index::Store> store = index::Store::open(options.index_path, index::Access::kReadWrite);
    if (!store.ok()) return store.error();
    const Result<std::vector<index::ModelSummary>> models =
        choose_models(*store, options.models, options.all_of_name);
    if (!models.ok()) return models.error();
    std::vector<index::Change> changes;
    for (const auto& model : *models) changes.emplace_back(index::RemoveModel{model.id});
    if (const auto applied = store->apply(changes); !applied.ok()) return applied.error();
    if (const auto updated = index::update_statistics(*store, session.jobs); !updated.ok()) {
        return updated.error();
    }
    if (session.json) {
        nlohmann::json ids = nlohmann::json::array();
        for (const auto& model : *models) ids.push_back(model.id);
        print_json({{"removed", std::move(ids)}});
    } else {
        for (const auto& model : *models) {
            std::cout << terminal_format("removed #{} {}\n", model.id, model.name);
        }
    }
    return ExitCode::kDone;
}

}  // namespace

void add_remove(CLI::App& app, Session& session) {
    auto options = std::make_shared<RemoveArguments>();
    CLI::App* command = app.add_subcommand("remove", "Remove models from an index");
    add_index_option(*command, options->index_path);
    command->add_option("MODEL", options->models, "Names or #ids")->required();
    command->add_flag("--all", options->all_of_name, "Every model of a name, not only the one");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
