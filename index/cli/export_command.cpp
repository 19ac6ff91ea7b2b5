#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "engine/core/whole_file.h"
#include "engine/mesh/write_mesh.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/cli/wavefront_lines.h"
#include "index/json_text.h"
#include "index/presentation.h"
#include "index/preview.h"

namespace ossuary::cli {
namespace {

struct ExportArguments {
    std::string index_path;
    std::string folder;
    std::vector<std::string> models;
};

Result<std::vector<index::ModelSummary>> chosen(index::Store& store,
                                                const ExportArguments& options) {
    if (options.models.empty()) {
        index::ModelFilter everything;
        everything.limit = 0;
        Result<index::ModelPage> page = store.models(everything);
        if (!page.ok()) return page.error();
        return std::move(page->models);
    }
    std::vector<index::ModelSummary> models;
    for (const std::string& text : options.models) {
        const auto named = find_models(store, text);
        if (!named.ok()) return named.error();
        models.insert(models.end(), named->begin(), named->end());
    }
    return models;
}

/// What is written of one model.
struct Exported {
    index::StoredSkeleton skeleton;
    nlohmann::json document;
};

Result<Exported> load(index::Store& store, const index::ModelSummary& model) {
    Result<index::StoredSkeleton> skeleton = store.skeleton(model.id);
    if (!skeleton.ok()) return skeleton.error();
    nlohmann::json document = index::to_json(model);
    document["skeleton"] = index::to_json(*skeleton);
    return Exported{*std::move(skeleton), std::move(document)};
}

// <id>.json, <id>.obj (skeleton), <id>.off (preview mesh) and <id>.png of one model: ids, since
// names may be anything and belong to several models.
Result<void> write_model(index::Store& store, const index::ModelSummary& model,
                         const std::filesystem::path& folder) {
    const Result<Exported> exported = load(store, model);
    if (!exported.ok()) return exported.error();
    const Result<index::PreviewMesh> preview = store.preview(model.id);
    if (!preview.ok()) return preview.error();
    const auto thumbnail = store.thumbnail(model.id);
    // A model of which no picture could be drawn has none.
    const bool pictured = thumbnail.ok() && !thumbnail->empty();
    if (!thumbnail.ok() && thumbnail.error().code != ErrorCode::kModelNotFound) {
        return thumbnail.error();
    }
    const std::string stem = std::to_string(model.id);
    for (const auto& written :
         {write_whole_file(folder / (stem + ".json"),
                           index::json_text(exported->document, 2) + "\n"),
          write_whole_file(folder / (stem + ".obj"), wavefront_lines(exported->skeleton.graph)),
          write_whole_file(folder / (stem + ".off"), mesh::to_off(index::mesh_of(*preview))),
          pictured ? write_whole_file(
                         folder / (stem + ".png"),
                         {reinterpret_cast<const char*>(thumbnail->data()), thumbnail->size()})
                   : Result<void>{}}) {
        if (!written.ok()) return written;
    }
    return {};
}

Result<void> print_model(index::Store& store, const index::ModelSummary& model) {
    const Result<Exported> exported = load(store, model);
    if (!exported.ok()) return exported.error();
    std::cout << index::json_text(exported->document) << '\n';
    return {};
}

Result<void> make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return {ErrorCode::kFileUnwritable, folder + ": " + error.message()};
    return {};
}

/// A model that could not be exported, on stderr at once and kept for the summary.
nlohmann::json report_failure(const index::ModelSummary& model, const Error& error,
                              const Session& session) {
    const std::string where = "model " + std::to_string(model.id) + ", " + model.name + ": ";
    print_error({error.code, where + error.message}, session);
    return {{"id", model.id},
            {"name", model.name},
            {"code", to_string(error.code)},
            {"message", error.message}};
}

// One model that cannot be exported does not keep the others back.
Result<ExitCode> run(const ExportArguments& options, const Session& session) {
    Result<index::Store> store = index::Store::open(options.index_path, index::Access::kReadOnly);
    if (!store.ok()) return store.error();
    const Result<std::vector<index::ModelSummary>> models = chosen(*store, options);
    if (!models.ok()) return models.error();
    if (!options.folder.empty()) {
        if (const auto made = make_folder(options.folder); !made.ok()) return made.error();
    }
    std::size_t written = 0;
    nlohmann::json failures = nlohmann::json::array();
    for (const index::ModelSummary& model : *models) {
        if (session.stop.stop_requested()) {
            return {ErrorCode::kCancelled,
                    terminal_format("stopped after {} of {} models", written, models->size())};
        }
        const Result<void> exported = options.folder.empty()
                                          ? print_model(*store, model)
                                          : write_model(*store, model, options.folder);
        if (exported.ok()) {
            ++written;
        } else {
            failures.push_back(report_failure(model, exported.error(), session));
        }
    }
    const bool complete = failures.empty();
    if (!options.folder.empty() && session.json) {
        print_json(
            {{"folder", options.folder}, {"written", written}, {"failures", std::move(failures)}});
    } else if (!options.folder.empty()) {
        std::cerr << terminal_format("{} of {} models written to {}\n", written, models->size(),
                                     options.folder);
    }
    return complete ? ExitCode::kDone : ExitCode::kSomeModelsFailed;
}

}  // namespace

void add_export(CLI::App& app, Session& session) {
    auto options = std::make_shared<ExportArguments>();
    CLI::App* command = app.add_subcommand(
        "export", "Print what an index holds as JSON Lines, or write it into a folder");
    add_index_option(*command, options->index_path);
    command->add_option("MODEL", options->models, "Names or #ids (default: all)");
    command
        ->add_option("--out", options->folder,
                     "Write <id>.json, .obj (skeleton), .off (preview) and .png into this folder")
        ->type_name("DIR");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
