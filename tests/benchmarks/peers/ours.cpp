// Our side of the comparisons in this folder, on one thread: one JSON document a line on stdout.
#include <ctime>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/mesh/read_mesh.h"
#include "engine/skeleton/skeletonize.h"
#include "engine/voxel/npy.h"
#include "engine/voxel/voxelize.h"

namespace {

using namespace ossuary;

constexpr const char* kUsage =
    "usage: ossuary_peer_ours voxelize RESOLUTION RUNS FOLDER MODEL.off…   solids as "
    "FOLDER/NAME.npy\n"
    "       ossuary_peer_ours skeletonize RUNS MODEL.off…                  mesh to refined "
    "skeleton\n"
    "RUNS runs of each model after one that warms up; runs_processor_ms has them all but that "
    "one.\n";

/// Milliseconds of processor time of each of `runs` runs after one that warms up.
template <typename Work>
std::vector<double> time_runs(int runs, Work&& work) {
    std::vector<double> times;
    work();
    for (int run = 0; run < runs; ++run) {
        const std::clock_t begin = std::clock();
        work();
        times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return times;
}

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

nlohmann::json voxelize_one(const std::string& path, int resolution, int runs,
                            const std::string& folder) {
    const Result<ReadMeshResult> read = read_mesh(path);
    if (!read) throw std::runtime_error(read.error().message);
    VoxelizeOptions options;
    options.resolution = resolution;
    Result<VoxelSolid> solid = voxelize(read->mesh, options);
    if (!solid) throw std::runtime_error(solid.error().message);
    const auto runs_processor_ms = time_runs(runs, [&] { solid = voxelize(read->mesh, options); });
    const std::string out = folder + "/" + stem_of(path) + ".npy";
    if (const auto written = write_npy(solid->volume, out); !written) {
        throw std::runtime_error(written.error().message);
    }
    const WorldFromGrid& grid = solid->world_from_grid;
    return {{"model", stem_of(path)},
            {"solid", out},
            {"voxels", solid->volume.count()},
            {"method", solid->method},
            {"origin", {grid.origin.x(), grid.origin.y(), grid.origin.z()}},
            {"voxel_size", grid.voxel_size},
            {"runs_processor_ms", runs_processor_ms}};
}

nlohmann::json skeletonize_one(const std::string& path, int runs) {
    const Result<ReadMeshResult> read = read_mesh(path);
    if (!read) throw std::runtime_error(read.error().message);
    const auto runs_processor_ms = time_runs(runs, [&] {
        if (const auto skeleton = skeletonize(read->mesh); !skeleton) {
            throw std::runtime_error(skeleton.error().message);
        }
    });
    return {{"model", stem_of(path)},
            {"faces", read->mesh.triangles.size()},
            {"runs_processor_ms", runs_processor_ms}};
}

int run(const std::vector<std::string>& words) {
    if (words.size() >= 5 && words[0] == "voxelize") {
        for (std::size_t i = 4; i < words.size(); ++i) {
            const auto document =
                voxelize_one(words[i], std::stoi(words[1]), std::stoi(words[2]), words[3]);
            std::cout << document.dump() << std::endl;
        }
        return 0;
    }
    if (words.size() >= 3 && words[0] == "skeletonize") {
        for (std::size_t i = 2; i < words.size(); ++i) {
            std::cout << skeletonize_one(words[i], std::stoi(words[1])).dump() << std::endl;
        }
        return 0;
    }
    std::cerr << kUsage;
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << "ossuary_peer_ours: " << error.what() << '\n';
        return 1;
    }
}
