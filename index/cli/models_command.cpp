#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

struct ModelsArguments {
    std::string index_path;
    std::string class_name;
    std::string name_contains;
    std::size_t limit = 0;
};

Result<ExitCode> run(const ModelsArguments& options, const Session& session) {
    Result<index::Store> store = index::Store::open(options.index_path, index::Access::kReadOnly);
    if (!store.ok()) return store.error();
    index::ModelFilter filter;
    filter.limit = options.limit;
    filter.name_contains = options.name_contains;
    if (!options.class_name.empty()) filter.class_name = options.class_name;
    const Result<index::ModelPage> page = store->models(filter);
    if (!page.ok()) return page.error();
    if (session.json) {
        nlohmann::json models = nlohmann::json::array();
        for (const auto& model : page->models) models.push_back(index::to_json(model));
        print_json(
            {{"models", std::move(models)}, {"total", page->total}, {"revision", page->revision}});
        return ExitCode::kDone;
    }
    Table table({{"id", Align::kRight},
                 {"name"},
                 {"class"},
                 {"faces", Align::kRight},
                 {"nodes", Align::kRight},
                 {"branches", Align::kRight},
                 {"path"}});
    for (const index::ModelSummary& model : page->models) {
        table.add_row({fmt::format("#{}", model.id), model.name,
                       model.class_name.empty() ? "-" : model.class_name,
                       std::to_string(model.faces), std::to_string(model.nodes),
                       std::to_string(model.branches), model.path.empty() ? "-" : model.path});
    }
    std::cout << table.text();
    std::cerr << terminal_format("{} of {} models\n", page->models.size(), page->total);
    return ExitCode::kDone;
}

}  // namespace

void add_models(CLI::App& app, Session& session) {
    auto options = std::make_shared<ModelsArguments>();
    CLI::App* command = app.add_subcommand("models", "List the models of an index");
    add_index_option(*command, options->index_path);
    command->add_option("--class", options->class_name, "Only this class");
    command->add_option("--name", options->name_contains, "Only names that contain this");
    command->add_option("--limit", options->limit, "How many (0 = all)")->capture_default_str();
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
