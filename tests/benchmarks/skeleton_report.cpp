// Figures of the skeleton engine for docs/: see kUsage.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/skeleton/simple_point.h"
#include "engine/skeleton/skeletonize.h"
#include "engine/skeleton/thinning_grid.h"
#include "engine/voxel/betti.h"
#include "engine/voxel/border.h"
#include "engine/voxel/distance_transform.h"

namespace {

using namespace ossuary;

constexpr const char* kUsage =
    "usage: ossuary_skeleton_report time RESOLUTION MODEL.off…   mean of each stage's processor "
    "time from mesh to refined skeleton, and the process' peak memory\n"
    "       ossuary_skeleton_report growth MODEL.off…            thinning from 128 to 512 voxels "
    "against border voxels times layers\n"
    "       ossuary_skeleton_report properties MODEL.off…        the properties of sec. 4.1.1\n";

ossuary::mesh::TriangleMesh mesh_of(const std::string& path) {
    Result<ossuary::mesh::ReadMeshResult> read = ossuary::mesh::read_mesh(path);
    if (!read) throw std::runtime_error(read.error().message);
    return std::move(read->mesh);
}

ossuary::skeleton::Skeleton skeleton_of(const ossuary::mesh::TriangleMesh& mesh,
                                        const ossuary::skeleton::SkeletonizeOptions& options = {}) {
    Result<ossuary::skeleton::Skeleton> skeleton = ossuary::skeleton::skeletonize(mesh, options);
    if (!skeleton) throw std::runtime_error(skeleton.error().message);
    return *std::move(skeleton);
}

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The largest resident set of this process so far, in MB of 2^20 bytes.
double peak_memory_mb() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word != "VmHWM:") continue;
        double kilobytes = 0;
        status >> kilobytes;
        return kilobytes / 1024;
    }
    throw std::runtime_error("/proc/self/status: no VmHWM");
}

void report_time(const std::vector<std::string>& models, int resolution) {
    ossuary::skeleton::SkeletonizeOptions options;
    options.voxelize.resolution = resolution;
    double total = 0.0;
    std::vector<double> of_stage;
    std::vector<std::string> names;
    std::vector<double> each;
    for (const std::string& path : models) {
        const ossuary::mesh::TriangleMesh mesh = mesh_of(path);
        const double begin = processor_ms();
        const ossuary::skeleton::Skeleton skeleton = skeleton_of(mesh, options);
        each.push_back(processor_ms() - begin);
        total += each.back();
        of_stage.resize(skeleton.stage_times.size(), 0.0);
        names.resize(of_stage.size());
        for (std::size_t i = 0; i < of_stage.size(); ++i) {
            names[i] = skeleton.stage_times[i].stage;
            of_stage[i] += skeleton.stage_times[i].milliseconds;
        }
    }
    const auto count = static_cast<double>(models.size());
    fmt::print("{} models at {}: mean {:.2f} ms of processor time, most {:.1f}\n", models.size(),
               resolution, total / count, *std::max_element(each.begin(), each.end()));
    for (std::size_t i = 0; i < of_stage.size(); ++i) {
        fmt::print("  {} {:.2f} ms (by the clock on the wall)\n", names[i], of_stage[i] / count);
    }
    fmt::print("  peak memory {:.1f} MB\n", peak_memory_mb());
}

/// The slope of a least-squares line through the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0.0, mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / static_cast<double>(x.size());
        mean_y += std::log(y[i]) / static_cast<double>(x.size());
    }
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        above += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
        below += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    }
    return above / below;
}

void report_growth(const std::vector<std::string>& models) {
    constexpr int kRuns = 3;
    std::vector<double> ratios;
    for (const std::string& path : models) {
        const ossuary::mesh::TriangleMesh mesh = mesh_of(path);
        std::vector<double> sides, times, ideals;
        for (const int resolution : {128, 192, 256, 384, 512}) {
            ossuary::voxel::VoxelizeOptions options;
            options.resolution = resolution;
            const Result<ossuary::voxel::VoxelSolid> solid =
                ossuary::voxel::voxelize(mesh, options);
            if (!solid) throw std::runtime_error(solid.error().message);
            std::vector<double> runs;
            std::uint32_t deepest = 0;
            for (int run = 0; run <= kRuns; ++run) {
                const double begin = processor_ms();
                const ossuary::voxel::DistanceField distance =
                    ossuary::voxel::distance_transform(solid->volume);
                const ossuary::voxel::BitVolume skeleton =
                    ossuary::skeleton::thin(solid->volume, distance);
                if (run > 0) runs.push_back(processor_ms() - begin);
                for (const std::uint32_t d : distance.values()) deepest = std::max(deepest, d);
            }
            std::nth_element(runs.begin(), runs.begin() + kRuns / 2, runs.end());
            sides.push_back(resolution);
            times.push_back(runs[kRuns / 2]);
            ideals.push_back(static_cast<double>(ossuary::voxel::border(solid->volume).count()) *
                             std::sqrt(static_cast<double>(deepest)));
        }
        const double measured = exponent(sides, times);
        const double ideal = exponent(sides, ideals);
        ratios.push_back(measured / ideal);
        fmt::print(
            "{}: {:.1f} ms at 128, {:.1f} at 512; exponent {:.2f}, ideal {:.2f}: {:+.0f} %\n", path,
            times.front(), times.back(), measured, ideal, 100 * (ratios.back() - 1));
        std::cout << std::flush;
    }
    std::nth_element(ratios.begin(),
                     ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
    fmt::print("median {:+.1f} %\n", 100 * (ratios[ratios.size() / 2] - 1));
}

/// Sums over models, and how many there were.
struct Mean {
    double sum = 0.0;
    std::size_t count = 0;
    void add(double value) {
        sum += value;
        ++count;
    }
    [[nodiscard]] double value() const { return sum / static_cast<double>(count); }
};

std::vector<Vec3> world_points(const ossuary::skeleton::SkeletonGraph& graph,
                               const WorldFromGrid& frame) {
    std::vector<Vec3> points;
    for (const auto& branch : ossuary::skeleton::to_world(graph, frame).branches) {
        points.insert(points.end(), branch.points.begin(), branch.points.end());
    }
    if (points.empty()) {
        for (const auto& node : ossuary::skeleton::to_world(graph, frame).nodes)
            points.push_back(node.position);
    }
    return points;
}

/// Mean distance from points of one set to the nearest of the other.
double mean_distance(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    double sum = 0.0;
    for (const Vec3& p : from) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& q : to) nearest = std::min(nearest, (p - q).squaredNorm());
        sum += std::sqrt(nearest);
    }
    return sum / static_cast<double>(from.size());
}

/// The mean angle between successive segments of a branch's polyline, in degrees, by length: the
/// turning a voxel of length.
double turning_per_voxel(const ossuary::skeleton::SkeletonGraph& graph) {
    double turning = 0.0, length = 0.0;
    for (const auto& branch : graph.branches) {
        length += branch.length();
        for (std::size_t i = 1; i + 1 < branch.points.size(); ++i) {
            const Vec3 a = branch.points[i] - branch.points[i - 1];
            const Vec3 b = branch.points[i + 1] - branch.points[i];
            if (a.norm() > 0 && b.norm() > 0) turning += std::atan2(a.cross(b).norm(), a.dot(b));
        }
    }
    return length > 0 ? turning / length * 180 / M_PI : 0.0;
}

struct Thinness {
    std::size_t voxels = 0;
    std::size_t crowds = 0;     ///< 2x2x2 blocks
    std::size_t removable = 0;  ///< simple voxels that are no ends
};

Thinness thinness_of(const ossuary::voxel::BitVolume& skeleton) {
    Thinness result;
    const ossuary::skeleton::ThinningGrid grid(skeleton);
    const auto& is_simple = ossuary::skeleton::SimplePointTest::shared();
    grid.for_each([&](ossuary::skeleton::VoxelIndex v) {
        ++result.voxels;
        const ossuary::skeleton::Neighborhood around = grid.neighborhood(v);
        constexpr ossuary::skeleton::Neighborhood kBlock =
            ossuary::skeleton::Neighborhood{0b11011} << 13 |
            ossuary::skeleton::Neighborhood{0b11011} << 22;
        if ((around & kBlock) == kBlock) ++result.crowds;
        if (std::popcount(around & ossuary::skeleton::k26Neighbors) >= 2 && is_simple(around))
            ++result.removable;
    });
    return result;
}

/// Radius over the largest in the 26 neighbours, averaged over the skeleton's voxels: 1 in the
/// middle.
double centredness_of(const ossuary::skeleton::Skeleton& skeleton) {
    Mean mean;
    ossuary::voxel::for_each_voxel(skeleton.thinned_volume, [&](const Vec3i& v) {
        double largest = 0.0;
        for (int bit = 0; bit < 27; ++bit) {
            const ossuary::skeleton::NeighborOffset o = ossuary::skeleton::neighbor_offset(bit);
            const Vec3i n = v + Vec3i(o.dx, o.dy, o.dz);
            if (skeleton.solid.volume.test_or_false(n)) {
                largest = std::max(largest, skeleton.distance.distance(n));
            }
        }
        mean.add(skeleton.distance.distance(v) / largest);
    });
    return mean.value();
}

void report_properties(const std::vector<std::string>& models) {
    std::size_t homotopic = 0, connected = 0;
    Thinness thinness;
    Mean centred, raw_turning, refined_turning, moved_raw, moved_refined, branches_raw,
        branches_refined, time;
    for (std::size_t i = 0; i < models.size(); ++i) {
        ossuary::mesh::TriangleMesh mesh = mesh_of(models[i]);
        const double begin = processor_ms();
        const ossuary::skeleton::Skeleton skeleton = skeleton_of(mesh);
        time.add(processor_ms() - begin);
        const ossuary::voxel::BettiNumbers before =
            ossuary::voxel::betti_numbers(skeleton.solid.volume);
        const ossuary::voxel::BettiNumbers after =
            ossuary::voxel::betti_numbers(skeleton.thinned_volume);
        homotopic += before == after ? 1 : 0;
        connected +=
            before.components == after.components &&
                    ossuary::skeleton::topology(skeleton.refined).components == before.components
                ? 1
                : 0;
        const Thinness thin = thinness_of(skeleton.thinned_volume);
        thinness.voxels += thin.voxels;
        thinness.crowds += thin.crowds;
        thinness.removable += thin.removable;
        centred.add(centredness_of(skeleton));
        raw_turning.add(turning_per_voxel(skeleton.thinned));
        refined_turning.add(turning_per_voxel(skeleton.refined));
        const double diagonal = ossuary::mesh::measure(mesh).diagonal;
        std::mt19937_64 random(i);
        std::normal_distribution<double> normal(0.0, 0.002 * diagonal);
        for (Vec3& vertex : mesh.vertices) {
            vertex += Vec3(normal(random), normal(random), normal(random));
        }
        const ossuary::skeleton::Skeleton noisy = skeleton_of(mesh);
        const auto moved = [&](const ossuary::skeleton::SkeletonGraph& a,
                               const ossuary::skeleton::SkeletonGraph& b) {
            const auto p = world_points(a, skeleton.solid.world_from_grid);
            const auto q = world_points(b, noisy.solid.world_from_grid);
            return 50 * (mean_distance(p, q) + mean_distance(q, p)) / diagonal;
        };
        moved_raw.add(moved(skeleton.thinned, noisy.thinned));
        moved_refined.add(moved(skeleton.refined, noisy.refined));
        const auto change = [](const ossuary::skeleton::SkeletonGraph& a,
                               const ossuary::skeleton::SkeletonGraph& b) {
            const auto difference =
                static_cast<double>(a.branches.size()) - static_cast<double>(b.branches.size());
            return std::abs(difference);
        };
        branches_raw.add(change(skeleton.thinned, noisy.thinned));
        branches_refined.add(change(skeleton.refined, noisy.refined));
    }
    fmt::print(
        "models {}\nhomotopy: Betti numbers kept in {}\nconnectivity: components kept by "
        "the refined skeleton in {}\n",
        models.size(), homotopic, connected);
    fmt::print("thinness: {} voxels, {} blocks of 2x2x2, {} simple voxels that are no ends\n",
               thinness.voxels, thinness.crowds, thinness.removable);
    fmt::print("centredness: {:.3f}\n", centred.value());
    fmt::print("smoothness: turning a voxel of length {:.1f} degrees raw, {:.1f} refined\n",
               raw_turning.value(), refined_turning.value());
    fmt::print(
        "robustness: {:.2f} % of the diagonal moved raw, {:.2f} % refined; branches more or "
        "less {:.2f} raw, {:.2f} refined\n",
        moved_raw.value(), moved_refined.value(), branches_raw.value(), branches_refined.value());
    fmt::print("efficiency: {:.1f} ms\n", time.value());
}

int run(std::vector<std::string> words) {
    if (words.size() >= 3 && words[0] == "time") {
        report_time({words.begin() + 2, words.end()}, std::stoi(words[1]));
        return 0;
    }
    if (words.size() >= 2 && (words[0] == "growth" || words[0] == "properties")) {
        const bool growth = words[0] == "growth";
        words.erase(words.begin());
        growth ? report_growth(words) : report_properties(words);
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
        std::cerr << "ossuary_skeleton_report: " << error.what() << '\n';
        return 1;
    }
}
