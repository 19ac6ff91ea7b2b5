#include "engine/decomposition/decompose.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "engine/decomposition/affinity.h"
#include "engine/decomposition/face_outwards.h"
#include "engine/decomposition/map_surface.h"
#include "engine/decomposition/merge_patches.h"
#include "engine/decomposition/prevailing_labels.h"
#include "engine/decomposition/refine_borders.h"
#include "engine/decomposition/small_parts.h"
#include "engine/decomposition/whole_faces.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"

namespace ossuary::decomposition {
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

std::vector<Decomposition::Part> describe_parts(
    const SurfaceGraph& surface, const Segmentation& segmentation,
    const std::vector<std::int32_t>& branch_of_triangle) {
    std::vector<Decomposition::Part> parts(segmentation.parts);
    for (std::size_t t = 0; t < surface.size(); ++t) {
        const std::uint32_t label = segmentation.labels[t];
        Decomposition::Part& part = parts[label];
        part.area += surface.areas[t];
        for (const std::uint32_t other : surface.across[t]) {
            if (other == mesh::kNoTriangle || segmentation.labels[other] == label) continue;
            part.neighbors.push_back(segmentation.labels[other]);
        }
    }
    const std::vector<std::int32_t> branches = prevailing_labels(
        segmentation.parts, segmentation.labels, branch_of_triangle, surface.areas);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        parts[p].branch = branches[p];
        auto& neighbors = parts[p].neighbors;
        std::sort(neighbors.begin(), neighbors.end());
        neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    }
    return parts;
}

/// What a method makes of a surface.
struct Labels {
    std::vector<std::uint32_t> part_of_triangle;
    std::vector<std::int32_t> branch_of_triangle;
};

Error decomposing_cancelled() { return {ErrorCode::kCancelled, "decomposing was cancelled"}; }

Error too_many_parts(std::size_t wanted, std::size_t possible) {
    return {ErrorCode::kInvalidArgument, "parts: expected at most " + std::to_string(possible) +
                                             ", found " + std::to_string(wanted)};
}

/// The thesis' parts are the branches themselves.
Labels label_by_branch(const SurfaceAndSkeleton& model, const DecomposeOptions& options,
                       const std::stop_token& stop, Decomposition& result) {
    Stopwatch watch;
    Labels labels;
    labels.part_of_triangle =
        map_surface(model.mended.mesh, result.skeleton, {.seed = options.seed}, stop);
    labels.branch_of_triangle.assign(labels.part_of_triangle.size(), -1);
    if (!result.skeleton.branches.empty()) {
        std::copy(labels.part_of_triangle.begin(), labels.part_of_triangle.end(),
                  labels.branch_of_triangle.begin());
    }
    result.stage_times.push_back({"map", watch.lap_ms()});
    return labels;
}

Labels label_by_evidence(const MeasuredPatches& patches, std::size_t parts,
                         const std::stop_token& stop, StageTimes& times) {
    Stopwatch watch;
    const std::vector<float> together = probability_together(patches.pairs);
    const std::vector<std::uint32_t> part_of_patch =
        merge_patches(patches.graph, together, {.parts = parts});
    Labels labels;
    for (const std::uint32_t patch : patches.graph.of_triangle) {
        labels.part_of_triangle.push_back(part_of_patch[patch]);
        labels.branch_of_triangle.push_back(patches.pairs.branch_of_patch[patch]);
    }
    times.push_back({"merge", watch.lap_ms()});
    refine_borders(patches.surface, labels.part_of_triangle, {}, stop);
    if (parts == 0) join_small_parts(patches.surface, labels.part_of_triangle);
    times.push_back({"borders", watch.lap_ms()});
    return labels;
}

/// All but the parts.
Decomposition begin_decomposition(const SurfaceAndSkeleton& model) {
    Decomposition result;
    result.stage_times = model.stage_times;
    result.warnings = mesh::mending_warnings(model.mended);
    const auto& of_solid = model.skeleton.solid.warnings;
    result.warnings.insert(result.warnings.end(), of_solid.begin(), of_solid.end());
    result.skeleton = model.refined;
    return result;
}

Decomposition finish_decomposition(SurfaceAndSkeleton model, Labels labels, Decomposition result) {
    label_whole_faces(model.surface, labels.part_of_triangle);
    result.on_surface = by_area(model.surface, labels.part_of_triangle);
    result.parts = describe_parts(model.surface, result.on_surface, labels.branch_of_triangle);
    result.segmentation.parts = result.on_surface.parts;
    result.segmentation.labels.reserve(model.mended.triangle_of.size());
    for (const std::uint32_t t : model.mended.triangle_of) {
        const std::uint32_t part = result.on_surface.labels[t];
        result.segmentation.labels.push_back(part);
        ++result.parts[part].triangles;
    }
    result.surface = std::move(model.mended);
    return result;
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

skeleton::SkeletonizeOptions decomposition_skeleton_options() {
    skeleton::SkeletonizeOptions options;
    options.voxelize.resolution = kResolution;
    options.refine.significance = false;
    return options;
}

Result<SurfaceAndSkeleton> surface_and_skeleton(mesh::MendedSurface surface,
                                                const DecomposeOptions& options,
                                                std::stop_token stop) {
    Result<skeleton::Skeleton> skeleton =
        skeleton::skeletonize(surface.mesh, options.skeletonize, stop);
    if (!skeleton) return skeleton.error();
    SurfaceAndSkeleton model;
    model.mended = std::move(surface);
    model.skeleton = *std::move(skeleton);
    model.stage_times = model.skeleton.stage_times;
    Stopwatch watch;
    model.refined =
        skeleton::to_world(model.skeleton.refined, model.skeleton.solid.world_from_grid);
    face_outwards(model.mended, model.refined);
    model.surface = surface_graph(model.mended.mesh, options.parts > 0);
    model.stage_times.push_back({"surface", watch.lap_ms()});
    return model;
}

Result<MeasuredPatches> measure_patches(mesh::MendedSurface surface,
                                        const DecomposeOptions& options, std::stop_token stop) {
    auto model = surface_and_skeleton(std::move(surface), options, stop);
    if (!model) return model.error();
    const std::size_t faces = count_faces(model->surface);
    if (options.parts > faces) return too_many_parts(options.parts, faces);
    MeasuredPatches patches{*std::move(model), {}, {}};
    Stopwatch watch;
    if (patches.surface.total_area <= 0.0) {
        patches.graph.of_triangle.assign(patches.surface.size(), 0);
        patches.graph.patches.resize(1);
        patches.graph.links.resize(1);
        patches.graph.patches[0].triangles = static_cast<std::uint32_t>(patches.surface.size());
    } else {
        patches.graph = patch_graph(
            patches.mended.mesh, patches.surface,
            {.count = std::max(options.patches, 4 * options.parts), .at_least = options.parts},
            stop);
    }
    patches.stage_times.push_back({"patches", watch.lap_ms()});
    if (stop.stop_requested()) return decomposing_cancelled();
    patches.pairs = pair_features(patches.surface, patches.graph, patches.skeleton, stop);
    if (stop.stop_requested()) return decomposing_cancelled();
    patches.stage_times.push_back({"pairs", watch.lap_ms()});
    return patches;
}

Result<Decomposition> decompose(const mesh::TriangleMesh& mesh, const DecomposeOptions& options,
                                std::stop_token stop) {
    if (mesh.empty()) return Error{ErrorCode::kMeshEmpty, "the mesh has no triangle"};
    return decompose(mesh::mend_surface(mesh), options, std::move(stop));
}

Result<Decomposition> decompose(mesh::MendedSurface surface, const DecomposeOptions& options,
                                std::stop_token stop) {
    if (options.parts > kMaxParts) return too_many_parts(options.parts, kMaxParts);
    if (options.method == DecompositionMethod::kThesis) {
        if (options.parts > 0) {
            return Error{ErrorCode::kInvalidArgument,
                         "parts: the thesis' method makes one of each branch of the skeleton"};
        }
        auto model = surface_and_skeleton(std::move(surface), options, stop);
        if (!model) return model.error();
        Decomposition result = begin_decomposition(*model);
        Labels labels = label_by_branch(*model, options, stop, result);
        if (stop.stop_requested()) return decomposing_cancelled();
        return finish_decomposition(*std::move(model), std::move(labels), std::move(result));
    }
    auto patches = measure_patches(std::move(surface), options, stop);
    if (!patches) return patches.error();
    if (options.parts > patches->graph.size()) {
        return too_many_parts(options.parts, patches->graph.size());
    }
    Decomposition result = begin_decomposition(*patches);
    Labels labels = label_by_evidence(*patches, options.parts, stop, result.stage_times);
    if (stop.stop_requested()) return decomposing_cancelled();
    return finish_decomposition(*std::move(patches), std::move(labels), std::move(result));
}

Segmentation face_segmentation(const mesh::TriangleMesh& mesh, const Segmentation& triangles) {
    std::vector<double> areas;
    areas.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        areas.push_back(mesh::triangle_area(mesh, t));
    const std::vector<std::int32_t> labels(triangles.labels.begin(), triangles.labels.end());
    Segmentation faces{{}, triangles.parts};
    for (const std::int32_t label :
         prevailing_labels(mesh.face_count, mesh.face_of_triangle, labels, areas)) {
        faces.labels.push_back(static_cast<std::uint32_t>(std::max(label, 0)));
    }
    return faces;
}

Segmentation triangle_segmentation(const mesh::TriangleMesh& mesh, const Segmentation& faces) {
    std::vector<std::uint32_t> labels;
    labels.reserve(mesh.triangles.size());
    for (const std::uint32_t face : mesh.face_of_triangle) labels.push_back(faces.labels[face]);
    return dense_segmentation(labels);
}

}  // namespace ossuary::decomposition
