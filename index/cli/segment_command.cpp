#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "engine/core/whole_file.h"
#include "engine/decomposition/decompose.h"
#include "engine/decomposition/seg_file.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/coloured_parts.h"
#include "index/json_text.h"
#include "index/model_segments.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

struct SegmentArguments {
    std::string model_path;
    std::vector<std::string> out;
    std::string method = "evidence";
    decomposition::DecomposeOptions decompose;
    VolumeOptions volume;
};

nlohmann::json document_of(const decomposition::Decomposition& decomposition,
                           const decomposition::Segmentation& faces,
                           const SegmentArguments& options, const StageTimes& times) {
    nlohmann::json parts = nlohmann::json::array();
    std::vector<std::size_t> face_counts(faces.parts, 0);
    for (const std::uint32_t label : faces.labels) ++face_counts[label];
    double total_area = 0.0;
    for (const auto& part : decomposition.parts) total_area += part.area;
    for (std::size_t p = 0; p < decomposition.parts.size(); ++p) {
        nlohmann::json part = index::to_json(decomposition.parts[p], total_area);
        part["part"] = p;
        part["faces"] = face_counts[p];
        parts.push_back(std::move(part));
    }
    double took_ms = 0.0;
    for (const StageTime& time : times) took_ms += time.milliseconds;
    return {{"name", std::filesystem::path(options.model_path).stem().string()},
            {"method", options.method},
            {"faces", faces.labels.size()},
            {"parts", std::move(parts)},
            {"stages_ms", index::to_json(times)},
            {"took_ms", took_ms}};
}

Result<void> write_out(const std::string& out, const mesh::TriangleMesh& mesh,
                       const decomposition::Decomposition& decomposition,
                       const decomposition::Segmentation& faces) {
    const std::string extension = std::filesystem::path(out).extension().string();
    if (extension == ".seg") return write_whole_file(out, decomposition::to_seg(faces));
    const std::vector<std::uint32_t>& parts = decomposition.segmentation.labels;
    const auto colours = [&] { return index::part_colours(decomposition.segmentation); };
    if (extension == ".ply") return write_whole_file(out, mesh::to_ply(mesh, colours()));
    if (extension == ".off") return write_whole_file(out, mesh::to_off(mesh, colours()));
    if (extension == ".obj") return write_whole_file(out, mesh::to_obj(mesh, parts, "part"));
    if (extension == ".stl") return write_whole_file(out, mesh::to_stl(mesh, parts, "part"));
    if (extension == ".glb") {
        const std::string name = std::filesystem::path(out).stem().string();
        const Result<std::string> rig = index::mesh_rig(mesh, decomposition, name);
        if (!rig.ok()) return rig.error();
        return write_whole_file(out, *rig);
    }
    return {ErrorCode::kInvalidArgument,
            fmt::format(
                "{}: parts are written as .seg (labels), .ply or .off (colours), .obj (groups), "
                ".stl (solids) or .glb (a rig)",
                out)};
}

void print_parts(const nlohmann::json& document) {
    std::cout << terminal_format("{}: {} parts of {} faces\n", document["name"].get<std::string>(),
                                 document["parts"].size(), document["faces"].get<std::size_t>());
    Table table({{"part", Align::kRight},
                 {"faces", Align::kRight},
                 {"area", Align::kRight},
                 {"branch", Align::kRight},
                 {"touches"}});
    for (const auto& part : document["parts"]) {
        table.add_row(
            {index::json_text(part["part"]), index::json_text(part["faces"]),
             fmt::format("{:.1f} %", 100.0 * part["area_share"].get<double>()),
             part["branch"].is_null() ? "-" : index::json_text(part["branch"]),
             fmt::format("{}", fmt::join(part["neighbors"].get<std::vector<int>>(), " "))});
    }
    std::cout << table.text();
}

Result<ExitCode> run(SegmentArguments options, const Session& session) {
    const Result<decomposition::DecompositionMethod> method =
        decomposition::parse_decomposition_method(options.method);
    if (!method.ok()) return method.error();
    options.decompose.method = *method;
    Stopwatch watch;
    const Result<mesh::ReadMeshResult> read =
        session.reader->read(options.model_path, options.volume.read_options(), session.stop);
    if (!read.ok()) return read.error();
    StageTimes times = {{"read", watch.lap_ms()}};
    const Result<decomposition::Decomposition> decomposition =
        decomposition::decompose(read->mesh, options.decompose, session.stop);
    if (!decomposition.ok()) return decomposition.error();
    times.insert(times.end(), decomposition->stage_times.begin(), decomposition->stage_times.end());
    const decomposition::Segmentation faces =
        decomposition::face_segmentation(read->mesh, decomposition->segmentation);
    for (const std::string& out : options.out) {
        const auto written = write_out(out, read->mesh, *decomposition, faces);
        if (!written.ok()) return written.error();
    }
    nlohmann::json document = document_of(*decomposition, faces, options, times);
    std::vector<mesh::MeshWarning> warnings = read->warnings;
    warnings.insert(warnings.end(), decomposition->warnings.begin(), decomposition->warnings.end());
    document["warnings"] = index::to_json(warnings);
    if (session.json) {
        print_json(document);
    } else {
        print_parts(document);
        for (const mesh::MeshWarning& warning : warnings) {
            std::cerr << terminal_format("warning: {}: {}\n", warning.code, warning.message);
        }
    }
    return ExitCode::kDone;
}

}  // namespace

void add_segment(CLI::App& app, Session& session) {
    auto options = std::make_shared<SegmentArguments>();
    CLI::App* command =
        app.add_subcommand("segment", "Cut a model into the parts that people would see");
    command->add_option("MODEL", options->model_path, "A model file")->required();
    command
        ->add_option("--out", options->out,
                     "Write .seg (the part of each face, a line each), .ply or .off (coloured "
                     "by part), .obj (a group each), .stl (a solid each) or .glb (rigged by the "
                     "skeleton); may be given for each")
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    command
        ->add_option("--parts", options->decompose.parts,
                     "As many parts as this (default: as the shape suggests)")
        ->check(CLI::Range(std::size_t{1}, decomposition::kMaxParts))
        ->type_name("K");
    command
        ->add_option("--method", options->method,
                     "evidence (ours) or thesis (a part for each branch of the skeleton)")
        ->check(CLI::IsMember({"evidence", "thesis"}))
        ->capture_default_str();
    command
        ->add_option("--seed", options->decompose.seed,
                     "thesis: of the random choice of surface points")
        ->capture_default_str();
    options->volume.add_to(*command);
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
