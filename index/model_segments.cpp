#include "index/model_segments.h"

#include <fmt/format.h>

#include "engine/decomposition/branch_mapping.h"
#include "engine/decomposition/carry_labels.h"
#include "engine/decomposition/prevailing_labels.h"
#include "engine/decomposition/rig.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/vertex_normals.h"
#include "engine/mesh/weld.h"
#include "index/coloured_parts.h"
#include "index/gltf.h"
#include "index/presentation.h"
#include "index/preview.h"

namespace ossuary::index {

namespace {

/// For each part the branch of the skeleton that most of its area is mapped to, -1 without one.
std::vector<std::int32_t> branches_of_parts(const mesh::TriangleMesh& mesh,
                                            const ModelSegments& segments,
                                            const skeleton::SkeletonGraph& skeleton,
                                            const std::stop_token& stop) {
    if (skeleton.branches.empty()) return std::vector<std::int32_t>(segments.parts.size(), -1);
    const decomposition::BranchMapping mapping(skeleton);
    const std::vector<Vec3> normals = mesh::triangle_normals(mesh);
    std::vector<std::int32_t> branches;
    branches.reserve(normals.size());
    for (std::size_t t = 0; t < normals.size(); ++t) {
        if (stop.stop_requested()) return {};
        const auto [a, b, c] = mesh.corners(t);
        branches.push_back(
            static_cast<std::int32_t>(mapping.branch_of((a + b + c) / 3.0, normals[t])));
    }
    return decomposition::prevailing_labels(segments.parts.size(), segments.labels, branches,
                                            mesh::triangle_areas(mesh));
}

Result<std::string> rig_of(const mesh::TriangleMesh& mesh, const decomposition::Segmentation& parts,
                           const skeleton::SkeletonGraph& skeleton, std::string_view name,
                           const std::stop_token& stop) {
    const mesh::TriangleMesh welded = weld(mesh, {.drop_collapsed = false}).mesh;
    const decomposition::Rig rig =
        decomposition::make_rig(welded, skeleton, decomposition::kRigSmoothing, stop);
    if (stop.stop_requested()) return {ErrorCode::kCancelled, "making the rig was given up"};
    return to_glb(welded, parts, rig, name);
}

}  // namespace

Result<ModelSegments> segment_model(const mesh::TriangleMesh& mesh,
                                    const mesh::TriangleMesh& preview,
                                    const skeleton::SkeletonGraph& skeleton, std::stop_token stop) {
    Result<decomposition::Decomposition> decomposition = decomposition::decompose(mesh, {}, stop);
    if (!decomposition) return decomposition.error();
    Result<decomposition::Segmentation> carried =
        decomposition::carry_labels(mesh, decomposition->segmentation, preview, stop);
    if (!carried) return carried.error();
    ModelSegments segments{std::move(decomposition->parts), std::move(carried->labels)};
    for (auto& part : segments.parts) part.triangles = 0;
    for (const std::uint32_t label : segments.labels) ++segments.parts[label].triangles;
    const auto branches = branches_of_parts(preview, segments, skeleton, stop);
    if (stop.stop_requested()) return {ErrorCode::kCancelled, "cutting into parts was given up"};
    for (std::size_t p = 0; p < branches.size(); ++p) segments.parts[p].branch = branches[p];
    return segments;
}

Result<std::string> model_rig(const PreviewMesh& preview, const ModelSegments& segments,
                              const skeleton::SkeletonGraph& skeleton, std::string_view name,
                              const std::stop_token& stop) {
    const mesh::TriangleMesh mesh = mesh_of(preview);
    if (segments.labels.size() != mesh.triangles.size()) {
        return {ErrorCode::kIndexCorrupt, "labels and triangles of the preview differ in number"};
    }
    const decomposition::Segmentation parts{segments.labels,
                                            static_cast<std::uint32_t>(segments.parts.size())};
    return rig_of(mesh, parts, skeleton, name, stop);
}

Result<std::string> mesh_rig(const mesh::TriangleMesh& mesh,
                             const decomposition::Decomposition& decomposition,
                             std::string_view name, const std::stop_token& stop) {
    return rig_of(mesh, decomposition.segmentation, decomposition.skeleton, name, stop);
}

nlohmann::json to_json(const ModelSegments& segments) {
    double total_area = 0.0;
    for (const auto& part : segments.parts) total_area += part.area;
    nlohmann::json parts = nlohmann::json::array();
    for (std::size_t p = 0; p < segments.parts.size(); ++p) {
        nlohmann::json part = to_json(segments.parts[p], total_area);
        const auto colour = part_colour(static_cast<std::uint32_t>(p));
        part["part"] = p;
        part["colour"] = fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
        parts.push_back(std::move(part));
    }
    return {{"parts", std::move(parts)}, {"labels", segments.labels}};
}

}  // namespace ossuary::index
