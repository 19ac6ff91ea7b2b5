#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/turn_model.h"

namespace ossuary::cli {
namespace {

struct UpArguments {
    std::string index_path;
    std::vector<std::string> words;  ///< models, and last the axis
    bool all_of_name = false;
};

Result<ExitCode> run(const UpArguments& options, const Session& session) {
    const auto up = parse_up_or_auto(options.words.back());
    if (!up.ok()) return up.error();
    Result<index::Store> store = index::Store::open(options.index_path, index::Access::kReadWrite);
    if (!store.ok()) return store.error();
    const auto models = choose_models(
        *store, {options.words.begin(), std::prev(options.words.end())}, options.all_of_name);
    if (!models.ok()) return models.error();
    nlohmann::json turned = nlohmann::json::array();
    for (const index::ModelSummary& model : *models) {
        const auto orientation = index::turn_model(*store, model.id, *up);
        if (!orientation.ok()) return orientation.error();
        const std::string_view axis = to_string(orientation->up);
        turned.push_back({{"id", model.id}, {"name", model.name}, {"up", axis}});
        if (!session.json) {
            std::cout << terminal_format("#{} {}: {} up\n", model.id, model.name, axis);
        }
    }
    if (session.json) print_json({{"models", std::move(turned)}});
    return ExitCode::kDone;
}

}  // namespace

void add_up(CLI::App& app, Session& session) {
    auto options = std::make_shared<UpArguments>();
    CLI::App* command = app.add_subcommand(
        "up", "Say which axis of a model points up; its picture is drawn anew, nothing is indexed");
    add_index_option(*command, options->index_path);
    constexpr int kMany = 1 << 20;
    command
        ->add_option("MODEL", options->words,
                     "Names or #ids; and last the axis: x, y, z, or auto (as the file says, else "
                     "found from the shape)")
        ->required()
        ->expected(2, kMany)
        ->type_name("... AXIS");
    command->add_flag("--all", options->all_of_name, "Every model of a name, not only the one");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
