#include "index/cli/index_arguments.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "engine/ranking/classification.h"
#include "index/cli/console.h"

namespace ossuary::cli {

void IndexArguments::add_to(CLI::App& command) {
    add_index_option(command, index_path);
    command.add_option("PATH", paths, "Model files, and folders to walk")->required();
    command
        .add_option("--classes", classes_path,
                    "Princeton classification (.cla) that names the models' classes")
        ->type_name("FILE");
    pipeline.add_to(command);
    volume.add_to(command);
    command
        .add_option("--exclude", exclude,
                    "Pass over files and folders whose name, or with a / in it whose path below "
                    "PATH, fits this pattern of *, ?, [a-z] and **; may be given again")
        ->expected(1)
        ->take_all()
        ->type_name("GLOB");
    command.add_flag("--split", split,
                     "Index each object of a file that tells several apart (3MF, glTF, OBJ, …) as "
                     "a model of its own, FILE#OBJECT; reads every file");
    command
        .add_option("--up", up,
                    "The axis that points up in these models, x, y or z; or auto: as its file says "
                    "or found for each new one, and others stay as they are")
        ->check(CLI::IsMember({"x", "y", "z", "auto"}))
        ->capture_default_str();
    command
        .add_option("--model-timeout", model_timeout_seconds,
                    "Seconds that one model may take (0 = for ever)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
}

Result<index::IndexParameters> IndexArguments::parameters() const {
    index::IndexParameters defaults;
    if (std::filesystem::exists(index_path)) {
        Result<index::Store> existing = index::Store::open(index_path, index::Access::kReadOnly);
        // An empty file becomes an index; whatever else is wrong is said by create_or_open.
        if (existing.ok()) defaults = existing->parameters();
    }
    return pipeline.parameters(defaults);
}

Result<index::IndexOptions> IndexArguments::options(const Session& session) const {
    index::IndexOptions options;
    options.paths.assign(paths.begin(), paths.end());
    options.jobs = session.jobs;
    options.reader = session.reader.get();
    for (const std::string& pattern : exclude) {
        Result<index::Glob> glob = index::Glob::parse(pattern);
        if (!glob.ok()) {
            return {glob.error().code, "--exclude " + glob.error().message};
        }
        options.walk.exclude.push_back(*std::move(glob));
    }
    options.inside = volume.inside;
    options.split = split;
    options.model_timeout_seconds = model_timeout_seconds;
    const auto axis = parse_up_or_auto(up);
    if (!axis.ok()) return axis.error();
    options.up = *axis;
    if (!classes_path.empty()) {
        Result<ranking::Classification> classes = ranking::read_classification(classes_path);
        if (!classes.ok()) return classes.error();
        options.classes = *std::move(classes);
    }
    return options;
}

std::string outcome_text(const index::IndexOutcome& outcome) {
    std::string text = fmt::format("{} indexed", outcome.indexed);
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) text += fmt::format(", {} {}", count, what);
    };
    add(outcome.unchanged, "unchanged");
    add(outcome.moved, "moved");
    add(outcome.classified, "with a new class");
    add(outcome.turned, "turned");
    add(outcome.pruned, "removed");
    add(outcome.failed, "failed");
    add(outcome.known_failures, "failed before (--retry-failed tries them again)");
    return text;
}

void print_refusals(const std::vector<index::PruneRefusal>& refusals, const Session& session) {
    for (const index::PruneRefusal& refusal : refusals) {
        print_error({ErrorCode::kPruneRefused,
                     fmt::format("{}: no model file is there, but the index has {} models of it; "
                                 "none of them was removed. If they are really gone, and not on a "
                                 "disk that is not mounted, `index --prune=force` removes them",
                                 refusal.place.string(), refusal.models)},
                    session);
    }
}

}  // namespace ossuary::cli
