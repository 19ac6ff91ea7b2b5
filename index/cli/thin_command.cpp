#include <fmt/format.h>

#include <ctime>
#include <iostream>
#include <memory>
#include <vector>

#include "engine/skeleton/thinning.h"
#include "engine/voxel/betti.h"
#include "engine/voxel/distance_transform.h"
#include "engine/voxel/npy.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

struct ThinArguments {
    std::string in;
    std::string out;
    std::string method = "anchored";
    int repeat = 1;
};

/// One thinning with what it needs, in milliseconds.
struct Run {
    voxel::BitVolume skeleton;
    double distance_ms = 0.0;
    double thin_ms = 0.0;
    double processor_ms = 0.0;
    [[nodiscard]] double took_ms() const { return distance_ms + thin_ms; }
};

Run run_once(const voxel::BitVolume& solid, const skeleton::ThinningOptions& options) {
    Run run;
    const std::clock_t begin = std::clock();
    Stopwatch watch;
    voxel::DistanceField distance;
    if (options.method == skeleton::ThinningMethod::kAnchored)
        distance = voxel::distance_transform(solid);
    run.distance_ms = watch.lap_ms();
    run.skeleton = skeleton::thin(solid, distance, options);
    run.thin_ms = watch.lap_ms();
    run.processor_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return run;
}

nlohmann::json to_json(const voxel::BettiNumbers& betti) {
    return {
        {"components", betti.components}, {"tunnels", betti.tunnels}, {"cavities", betti.cavities}};
}

Result<ExitCode> run(const ThinArguments& options, const Session& session) {
    skeleton::ThinningOptions thinning;
    const Result<skeleton::ThinningMethod> method = skeleton::parse_thinning_method(options.method);
    if (!method.ok()) return method.error();
    thinning.method = *method;
    const Result<voxel::BitVolume> solid = voxel::read_npy(options.in);
    if (!solid.ok()) return solid.error();

    std::vector<double> runs_ms;
    std::vector<double> runs_processor_ms;
    Run last;
    for (int i = 0; i < options.repeat; ++i) {
        last = run_once(*solid, thinning);
        runs_ms.push_back(last.took_ms());
        runs_processor_ms.push_back(last.processor_ms);
    }
    const voxel::BitVolume& skeleton = last.skeleton;
    if (const auto written = voxel::write_npy(skeleton, options.out); !written.ok()) {
        return written.error();
    }

    const voxel::BettiNumbers before = voxel::betti_numbers(*solid);
    const voxel::BettiNumbers after = voxel::betti_numbers(skeleton);
    if (session.json) {
        print_json({{"method", options.method},
                    {"size", {solid->size().x(), solid->size().y(), solid->size().z()}},
                    {"voxels_in", solid->count()},
                    {"voxels_out", skeleton.count()},
                    {"betti_in", to_json(before)},
                    {"betti_out", to_json(after)},
                    {"distance_transform_ms", last.distance_ms},
                    {"thin_ms", last.thin_ms},
                    {"took_ms", last.took_ms()},
                    {"runs_ms", runs_ms},
                    {"runs_processor_ms", runs_processor_ms}});
    } else {
        std::cout << terminal_format(
            "{} -> {} voxels; {} components, {} tunnels, {} cavities; distance transform {:.1f} "
            "ms, "
            "thinning {:.1f} ms\n",
            solid->count(), skeleton.count(), after.components, after.tunnels, after.cavities,
            last.distance_ms, last.thin_ms);
    }
    if (before != after) {
        return {ErrorCode::kInternal, "thinning has changed the volume's topology"};
    }
    return ExitCode::kDone;
}

}  // namespace

void add_thin(CLI::App& app, Session& session) {
    auto options = std::make_shared<ThinArguments>();
    CLI::App* command = app.add_subcommand(
        "thin", "Thin a solid volume (uint8 .npy) to its curve skeleton, topology kept");
    command->add_option("IN", options->in, "3-D .npy, everything but 0 is solid")->required();
    command->add_option("OUT", options->out, "The skeleton's voxels as .npy")->required();
    command->add_option("--method", options->method, "anchored (ours) or parallel (the thesis')")
        ->check(CLI::IsMember({"anchored", "parallel"}))
        ->capture_default_str();
    command
        ->add_option("--repeat", options->repeat,
                     "Thin this many times; times are the last run's, runs_ms has all")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
