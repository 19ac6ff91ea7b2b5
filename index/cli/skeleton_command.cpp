#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "engine/core/whole_file.h"
#include "engine/mesh/read_mesh.h"
#include "engine/skeleton/skeletonize.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/cli/wavefront_lines.h"
#include "index/json_text.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

struct SkeletonArguments {
    std::string model_path;
    std::string stage = "refined";
    std::string out;
    PipelineOptions pipeline;
    VolumeOptions volume;
};

const skeleton::SkeletonGraph& stage_of(const skeleton::Skeleton& skeleton,
                                        const std::string& stage) {
    if (stage == "thinned") return skeleton.thinned;
    if (stage == "pruned") return skeleton.pruned;
    return skeleton.refined;
}

nlohmann::json document_of(const skeleton::SkeletonGraph& graph, const SkeletonArguments& options,
                           const StageTimes& times,
                           const std::vector<mesh::MeshWarning>& warnings) {
    const skeleton::GraphTopology shape = skeleton::topology(graph);
    nlohmann::json document = index::to_json(graph);
    document["name"] = std::filesystem::path(options.model_path).stem().string();
    document["stage"] = options.stage;
    document["components"] = shape.components;
    document["cycles"] = shape.cycles;
    document["stages_ms"] = index::to_json(times);
    document["warnings"] = index::to_json(warnings);
    return document;
}

Result<void> write_out(const std::string& out, const skeleton::SkeletonGraph& graph,
                       const nlohmann::json& document) {
    const std::string extension = std::filesystem::path(out).extension().string();
    if (extension == ".obj") return write_whole_file(out, wavefront_lines(graph));
    if (extension == ".json") return write_whole_file(out, index::json_text(document, 2) + "\n");
    return {ErrorCode::kInvalidArgument,
            fmt::format("{}: a skeleton is written as .obj or .json", out)};
}

void print_summary(const skeleton::SkeletonGraph& graph, const SkeletonArguments& options,
                   const StageTimes& times, const std::vector<mesh::MeshWarning>& warnings) {
    const skeleton::GraphTopology shape = skeleton::topology(graph);
    double length = 0.0;
    for (const auto& branch : graph.branches) length += branch.length();
    std::cout << terminal_format(
        "{} skeleton: {} nodes, {} branches, {} components, {} cycles, length {:.6g}\n",
        options.stage, graph.nodes.size(), graph.branches.size(), shape.components, shape.cycles,
        length);
    for (const mesh::MeshWarning& warning : warnings) {
        std::cerr << terminal_format("warning: {}: {}\n", warning.code, warning.message);
    }
    for (const StageTime& time : times) {
        std::cerr << terminal_format("{:<20} {:8.2f} ms\n", time.stage, time.milliseconds);
    }
}

Result<ExitCode> run(const SkeletonArguments& options, const Session& session) {
    const Result<index::IndexParameters> parameters = options.pipeline.parameters();
    if (!parameters.ok()) return parameters.error();
    Stopwatch watch;
    const Result<mesh::ReadMeshResult> read =
        session.reader->read(options.model_path, options.volume.read_options(), session.stop);
    if (!read.ok()) return read.error();
    StageTimes times = {{"read", watch.lap_ms()}};
    const Result<skeleton::Skeleton> skeleton = skeleton::skeletonize(
        read->mesh, index::describe_options(*parameters).skeletonize, session.stop);
    if (!skeleton.ok()) return skeleton.error();
    times.insert(times.end(), skeleton->stage_times.begin(), skeleton->stage_times.end());
    std::vector<mesh::MeshWarning> warnings = read->warnings;
    warnings.insert(warnings.end(), skeleton->solid.warnings.begin(),
                    skeleton->solid.warnings.end());

    const skeleton::SkeletonGraph graph =
        skeleton::to_world(stage_of(*skeleton, options.stage), skeleton->solid.world_from_grid);
    const nlohmann::json document = document_of(graph, options, times, warnings);
    if (!options.out.empty()) {
        if (const auto written = write_out(options.out, graph, document); !written.ok()) {
            return written.error();
        }
    }
    if (session.json) {
        print_json(document);
    } else {
        print_summary(graph, options, times, warnings);
    }
    return ExitCode::kDone;
}

}  // namespace

void add_skeleton(CLI::App& app, Session& session) {
    auto options = std::make_shared<SkeletonArguments>();
    CLI::App* command = app.add_subcommand("skeleton", "Extract the curve skeleton of a model");
    command->add_option("MODEL", options->model_path, "A model file")->required();
    command->add_option("--stage", options->stage, "thinned, pruned or refined")
        ->check(CLI::IsMember({"thinned", "pruned", "refined"}))
        ->capture_default_str();
    command
        ->add_option("--out", options->out,
                     "Write it as .obj (polylines) or .json, in the model's own coordinates")
        ->type_name("FILE");
    options->pipeline.add_to(*command);
    options->volume.add_to(*command);
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
