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
    "FOLDER/NAME.npy, and sampled at voxel centres only as FOLDER/NAME-sampled.npy\n"
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

/// Adds to `document` the solid of a mesh, written to `out`, and the times that it took.
ossuary::voxel::VoxelSolid time_voxelize(const ossuary::mesh::TriangleMesh& mesh,
                                         const ossuary::voxel::VoxelizeOptions& options, int runs,
                                         const std::string& out, nlohmann::json& document) {
    Result<ossuary::voxel::VoxelSolid> solid = ossuary::voxel::voxelize(mesh, options);
    if (!solid) throw std::runtime_error(solid.error().message);
    document["runs_processor_ms"] =
        time_runs(runs, [&] { solid = ossuary::voxel::voxelize(mesh, options); });
    if (const auto written = ossuary::voxel::write_npy(solid->volume, out); !written) {
        throw std::runtime_error(written.error().message);
    }
    document["solid"] = out;
    return std::move(*solid);
}

nlohmann::json voxelize_one(const std::string& path, int resolution, int runs,
                            const std::string& folder) {
    const Result<ossuary::mesh::ReadMeshResult> read = ossuary::mesh::read_mesh(path);
    if (!read) throw std::runtime_error(read.error().message);
    ossuary::voxel::VoxelizeOptions options;
    options.resolution = resolution;
    nlohmann::json document = {{"model", stem_of(path)}};
    const std::string out = folder + "/" + stem_of(path);
    const ossuary::voxel::VoxelSolid solid =
        time_voxelize(read->mesh, options, runs, out + ".npy", document);
    // What a rasteriser does that knows of no thin parts, cavities, components and tunnels.
    options.keep_thin_parts = options.fill_cavities = options.close_small_tunnels = false;
    options.bridge_gap = 0;
    options.min_component_extent = 0;
    time_voxelize(read->mesh, options, runs, out + "-sampled.npy", document["sampled"]);
    const WorldFromGrid& grid = solid.world_from_grid;
    document["voxels"] = solid.volume.count();
    document["method"] = solid.method;
    document["origin"] = {grid.origin.x(), grid.origin.y(), grid.origin.z()};
    document["voxel_size"] = grid.voxel_size;
    return document;
}

nlohmann::json skeletonize_one(const std::string& path, int runs) {
    const Result<ossuary::mesh::ReadMeshResult> read = ossuary::mesh::read_mesh(path);
    if (!read) throw std::runtime_error(read.error().message);
    const auto runs_processor_ms = time_runs(runs, [&] {
        if (const auto skeleton = ossuary::skeleton::skeletonize(read->mesh); !skeleton) {
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
