#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "index/cli/command.h"
#include "index/cli/options.h"
#include "index/cli/write_file.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

struct Options {
    std::string index_path;
    std::string folder;
    std::vector<std::string> models;
};

Result<std::vector<index::ModelSummary>> chosen(index::Store& store, const Options& options) {
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

std::string off_text(const index::PreviewMesh& mesh) {
    std::string text =
        fmt::format("OFF\n{} {} 0\n", mesh.positions.size() / 3, mesh.triangles.size() / 3);
    for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3) {
        text += fmt::format("{} {} {}\n", mesh.positions[i], mesh.positions[i + 1],
                            mesh.positions[i + 2]);
    }
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        text += fmt::format("3 {} {} {}\n", mesh.triangles[i], mesh.triangles[i + 1],
                            mesh.triangles[i + 2]);
    }
    return text;
}

// <id>.json, <id>.obj (skeleton), <id>.off (preview mesh) and <id>.png of one model.
Result<void> write_model(index::Store& store, const index::ModelSummary& model,
                         const std::filesystem::path& folder, const nlohmann::json& document,
                         const index::StoredSkeleton& skeleton) {
    const std::string stem = std::to_string(model.id);
    const Result<index::PreviewMesh> preview = store.preview(model.id);
    if (!preview.ok()) return preview.error();
    const auto thumbnail = store.thumbnail(model.id);
    if (!thumbnail.ok()) return thumbnail.error();
    const std::string_view png(reinterpret_cast<const char*>(thumbnail->data()), thumbnail->size());
    for (const auto& written :
         {write_file(folder / (stem + ".json"), document.dump(2) + "\n"),
          write_file(folder / (stem + ".obj"), wavefront_lines(skeleton.graph)),
          write_file(folder / (stem + ".off"), off_text(*preview)),
          png.empty() ? Result<void>{} : write_file(folder / (stem + ".png"), png)}) {
        if (!written.ok()) return written;
    }
    return {};
}

Result<ExitCode> run(const Options& options) {
    Result<index::Store> store = index::Store::open(options.index_path, index::Access::kReadOnly);
    if (!store.ok()) return store.error();
    const Result<std::vector<index::ModelSummary>> models = chosen(*store, options);
    if (!models.ok()) return models.error();
    if (!options.folder.empty()) {
        std::error_code error;
        std::filesystem::create_directories(options.folder, error);
        if (error) {
            return {ErrorCode::kFileUnwritable,
                    fmt::format("{}: {}", options.folder, error.message())};
        }
    }
    for (const index::ModelSummary& model : *models) {
        const Result<index::StoredSkeleton> skeleton = store->skeleton(model.id);
        if (!skeleton.ok()) return skeleton.error();
        nlohmann::json document = index::to_json(model);
        document["skeleton"] = index::to_json(*skeleton);
        if (options.folder.empty()) {
            std::cout << document.dump() << '\n';
        } else if (const auto written =
                       write_model(*store, model, options.folder, document, *skeleton);
                   !written.ok()) {
            return written.error();
        }
    }
    if (!options.folder.empty()) {
        std::cerr << fmt::format("{} models written to {}\n", models->size(), options.folder);
    }
    return ExitCode::kDone;
}

}  // namespace

void add_export(CLI::App& app, Session& session) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "export", "Print what an index holds as JSON Lines, or write it into a folder");
    add_index_option(*command, options->index_path);
    command->add_option("MODEL", options->models, "Names or #ids (default: all)");
    command
        ->add_option("--out", options->folder,
                     "Write <id>.json, .obj (skeleton), .off (preview) and .png into this folder")
        ->type_name("DIR");
    set_body(*command, session, [options] { return run(*options); });
}

}  // namespace ossuary::cli
