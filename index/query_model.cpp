#include "index/query_model.h"

#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "index/model_segments.h"
#include "index/preview.h"
#include "index/upright.h"

namespace ossuary::index {

namespace {

std::vector<mesh::MeshWarning> joined(std::vector<mesh::MeshWarning> first,
                                      const std::vector<mesh::MeshWarning>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::size_t bytes_of(const mesh::TriangleMesh& mesh) {
    return mesh.vertices.size() * sizeof(Vec3) +
           mesh.triangles.size() * sizeof(mesh::TriangleMesh::Triangle) +
           mesh.face_of_triangle.size() * sizeof(std::uint32_t);
}

}  // namespace

QueryModel::QueryModel(std::string name, mesh::TriangleMesh mesh,
                       std::vector<mesh::MeshWarning> warnings, const FileFrame& frame,
                       DescribedQuery described)
    : name_(std::move(name)),
      mesh_(std::move(mesh)),
      described_(std::move(described)),
      warnings_(joined(std::move(warnings), described_.warnings)),
      bounds_(mesh::measure(described_.body.of(mesh_)).bounds),
      frame_(frame) {}

Result<Up> QueryModel::up(const std::stop_token& stop) {
    if (frame_.up) return *frame_.up;
    const Lock lock(mutex_);
    const auto mesh = coarse(stop);
    if (!mesh) return mesh.error();
    return find_up(*mesh);
}

Result<mesh::TriangleMesh> QueryModel::coarse(const std::stop_token& stop) {
    if (!coarse_) {
        auto made = mesh::decimate(described_.body.of(mesh_), {}, stop);
        // A mesh that was given up on is finer than it should be.
        if (stop.stop_requested()) return {ErrorCode::kCancelled, name_ + ": given up"};
        coarse_ = std::move(made);
    }
    return *coarse_;
}

Result<PreviewMesh> QueryModel::preview(const std::stop_token& stop) {
    const Lock lock(mutex_);
    const auto mesh = coarse(stop);
    if (!mesh) return mesh.error();
    return make_preview(*mesh);
}

const registration::PieceQuery& QueryModel::piece() {
    const Lock lock(mutex_);
    if (!piece_) piece_ = registration::piece_query(described_.body.of(mesh_));
    return *piece_;
}

Result<ModelSegments> QueryModel::segments(const std::stop_token& stop) {
    // Whoever asks meanwhile waits and has them at once.
    const Lock lock(mutex_);
    if (!segments_) {
        const auto mesh = coarse(stop);
        if (!mesh) return mesh.error();
        auto made = segment_model(mesh_, *mesh, described_.skeleton.graph, stop);
        if (!made) return made.error();
        segments_ = *std::move(made);
    }
    return *segments_;
}

std::size_t QueryModel::bytes() const {
    constexpr std::size_t kDescription = 256 << 10;
    const auto& body = described_.body.mesh;
    return bytes_of(mesh_) + (body ? bytes_of(*body) : 0) + kDescription;
}

}  // namespace ossuary::index
