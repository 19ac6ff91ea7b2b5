#include "index/reader/scene_builder.h"

#include <utility>

#include "engine/mesh/colours_on.h"

namespace ossuary::index {

SceneBuilder::SceneBuilder(const mesh::ReadMeshOptions& caps, Corners corners)
    : builder_(
          {ErrorCode::kModelTooManyVertices, ErrorCode::kModelTooManyFaces,
           ErrorCode::kModelTooManyCorners, ErrorCode::kModelNonFinite, ErrorCode::kModelNonFinite},
          caps, {}),
      corners_(corners) {}

void SceneBuilder::begin_object(std::string name) {
    object_ = {std::move(name), builder_.triangle_count(), 0};
    first_vertex_ = static_cast<std::uint32_t>(builder_.vertices().size());
    if (corners_ == Corners::kJoin) table_ = mesh::VertexTable();
}

Result<std::uint32_t> SceneBuilder::add_vertex(const Vec3& position) {
    const auto next = static_cast<std::uint32_t>(builder_.vertices().size());
    if (!builder_.is_in_range(position)) return builder_.position_error(next, position);
    if (corners_ == Corners::kJoin) {
        const std::uint32_t number = first_vertex_ + table_.number_of(position);
        if (number < next) return number;
    }
    if (auto counted = builder_.check_counts(next + 1, 0); !counted) return counted.error();
    builder_.add_vertex(position);
    return next;
}

Result<void> SceneBuilder::add_face(std::span<const std::uint32_t> corners) {
    if (auto counted = builder_.check_counts(0, builder_.face_count() + std::uint64_t{1});
        !counted) {
        return counted;
    }
    if (auto checked = builder_.check_corners(corners.size()); !checked) return checked;
    return builder_.add_face(corners);
}

void SceneBuilder::end_object() {
    object_.triangles = builder_.triangle_count() - object_.first_triangle;
    if (object_.triangles > 0) objects_.push_back(std::move(object_));
}

mesh::ReadMeshResult SceneBuilder::take() {
    mesh::ReadMeshResult read = builder_.take();
    if (mesh::is_white(read.mesh)) read.mesh.corner_colours = {};
    read.objects = std::move(objects_);
    return read;
}

}  // namespace ossuary::index
