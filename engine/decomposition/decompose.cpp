#include "engine/decomposition/decompose.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "engine/decomposition/affinity.h"
#include "engine/decomposition/map_surface.h"
#include "engine/decomposition/merge_patches.h"
#include "engine/decomposition/refine_borders.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/weld.h"

namespace ossuary {
namespace {

constexpr int kResolution = 64;

/// Numbers the parts by descending area, the earlier triangle first among equals.
Segmentation by_area(const SurfaceGraph& surface, const std::vector<std::uint32_t>& labels) {
    const Segmentation dense = dense_segmentation(labels);
    std::vector<double> areas(dense.parts, 0.0);
    for (std::size_t t = 0; t < labels.size(); ++t) areas[dense.labels[t]] += surface.areas[t];
    std::vector<std::uint32_t> order(dense.parts), rank(dense.parts);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
    for (std::uint32_t r = 0; r < order.size(); ++r) rank[order[r]] = r;
    Segmentation sorted{{}, dense.parts};
    for (const std::uint32_t label : dense.labels) sorted.labels.push_back(rank[label]);
    return sorted;
}

std::vector<Decomposition::Part> describe_parts(const MeasuredPatches& patches,
                                                const Segmentation& segmentation) {
    std::vector<Decomposition::Part> parts(segmentation.parts);
    std::vector<std::map<std::int32_t, double>> area_of_branch(segmentation.parts);
    const SurfaceGraph& surface = patches.surface;
    for (std::size_t t = 0; t < surface.size(); ++t) {
        const std::uint32_t label = segmentation.labels[t];
        Decomposition::Part& part = parts[label];
        ++part.triangles;
        part.area += surface.areas[t];
        const std::int32_t branch = patches.pairs.branch_of_patch[patches.graph.of_triangle[t]];
        if (branch >= 0) area_of_branch[label][branch] += surface.areas[t];
        for (const std::uint32_t other : surface.across[t]) {
            if (other == kNoTriangle || segmentation.labels[other] == label) continue;
            part.neighbors.push_back(segmentation.labels[other]);
        }
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
        auto& neighbors = parts[p].neighbors;
        std::sort(neighbors.begin(), neighbors.end());
        neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
        double largest = 0.0;
        for (const auto& [branch, area] : area_of_branch[p]) {
            if (area <= largest) continue;
            largest = area;
            parts[p].branch = branch;
        }
    }
    return parts;
}

std::vector<std::uint32_t> merged_labels(const MeasuredPatches& patches, std::size_t parts,
                                         StageTimes& times) {
    Stopwatch watch;
    const std::vector<float> together = probability_together(patches.pairs);
    const std::vector<std::uint32_t> part_of_patch =
        merge_patches(patches.graph, together, {.parts = parts});
    std::vector<std::uint32_t> labels;
    labels.reserve(patches.graph.of_triangle.size());
    for (const std::uint32_t patch : patches.graph.of_triangle) {
        labels.push_back(part_of_patch[patch]);
    }
    times.push_back({"merge", watch.lap_ms()});
    refine_borders(patches.surface, labels);
    times.push_back({"borders", watch.lap_ms()});
    return labels;
}

Error too_many_parts(std::size_t wanted, std::size_t possible) {
    return {ErrorCode::kInvalidArgument, "parts: expected at most " + std::to_string(possible) +
                                             ", found " + std::to_string(wanted)};
}

}  // namespace

std::string_view to_string(DecompositionMethod method) {
    return method == DecompositionMethod::kThesis ? "thesis" : "evidence";
}

Result<DecompositionMethod> parse_decomposition_method(std::string_view name) {
    for (const auto method : {DecompositionMethod::kEvidence, DecompositionMethod::kThesis}) {
        if (name == to_string(method)) return method;
    }
    return Error{ErrorCode::kInvalidArgument,
                 "method: expected evidence or thesis, found '" + std::string(name) + "'"};
}

SkeletonizeOptions decomposition_skeleton_options() {
    SkeletonizeOptions options;
    options.voxelize.resolution = kResolution;
    return options;
}

Result<MeasuredPatches> measure_patches(const TriangleMesh& mesh, const DecomposeOptions& options,
                                        std::stop_token stop) {
    Result<Skeleton> skeleton = skeletonize(mesh, options.skeletonize, stop);
    if (!skeleton) return skeleton.error();
    MeasuredPatches patches;
    patches.skeleton = *std::move(skeleton);
    patches.stage_times = patches.skeleton.stage_times;
    Stopwatch watch;
    const auto lap = [&](const char* stage) {
        patches.stage_times.push_back({stage, watch.lap_ms()});
    };
    patches.mesh = weld(mesh, {.drop_collapsed = false}).mesh;
    patches.surface = surface_graph(patches.mesh);
    lap("surface");
    if (patches.surface.total_area <= 0.0) {
        patches.graph.of_triangle.assign(mesh.triangles.size(), 0);
        patches.graph.patches.resize(1);
        patches.graph.links.resize(1);
        patches.graph.patches[0].triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    } else {
        const std::size_t count = std::max(options.patches, 4 * options.parts);
        patches.graph = patch_graph(patches.mesh, patches.surface, count);
    }
    lap("patches");
    if (stop.stop_requested()) return Error{ErrorCode::kCancelled, "decomposing was cancelled"};
    patches.pairs = pair_features(patches.surface, patches.graph, patches.skeleton);
    lap("pairs");
    return patches;
}

Result<Decomposition> decompose(const TriangleMesh& mesh, const DecomposeOptions& options,
                                std::stop_token stop) {
    if (options.parts > kMaxParts) return too_many_parts(options.parts, kMaxParts);
    const bool is_thesis = options.method == DecompositionMethod::kThesis;
    if (is_thesis && options.parts > 0) {
        return Error{ErrorCode::kInvalidArgument,
                     "parts: the thesis' method makes one of each branch of the skeleton"};
    }
    Result<MeasuredPatches> measured = measure_patches(mesh, options, stop);
    if (!measured) return measured.error();
    const MeasuredPatches& patches = *measured;
    if (options.parts > patches.graph.size()) {
        return too_many_parts(options.parts, patches.graph.size());
    }
    Decomposition result;
    result.stage_times = patches.stage_times;
    result.warnings = patches.skeleton.solid.warnings;
    result.skeleton = to_world(patches.skeleton.refined, patches.skeleton.solid.world_from_grid);
    std::vector<std::uint32_t> labels;
    if (is_thesis) {
        Stopwatch watch;
        labels = map_surface(patches.mesh, result.skeleton, {.seed = options.seed});
        result.stage_times.push_back({"map", watch.lap_ms()});
    } else {
        labels = merged_labels(patches, options.parts, result.stage_times);
    }
    result.segmentation = by_area(patches.surface, labels);
    result.parts = describe_parts(patches, result.segmentation);
    return result;
}

Segmentation face_segmentation(const TriangleMesh& mesh, const Segmentation& triangles) {
    Segmentation faces{std::vector<std::uint32_t>(mesh.face_count, 0), triangles.parts};
    std::vector<std::map<std::uint32_t, double>> area(mesh.face_count);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        area[mesh.face_of_triangle[t]][triangles.labels[t]] += triangle_area(mesh, t);
    }
    for (std::size_t face = 0; face < area.size(); ++face) {
        double largest = -1.0;
        for (const auto& [label, size] : area[face]) {
            if (size <= largest) continue;
            largest = size;
            faces.labels[face] = label;
        }
    }
    return faces;
}

}  // namespace ossuary
