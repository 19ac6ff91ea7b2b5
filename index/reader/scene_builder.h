#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/vertex_table.h"

namespace ossuary::index {

/// Puts the objects of a scene into one mesh, one after the other.
class SceneBuilder {
public:
    enum class Corners {
        kKeep,  ///< vertices are those of the file
        kJoin,  ///< vertices of an object at equal positions are one
    };

    /// `caps` must outlive the builder.
    SceneBuilder(const mesh::ReadMeshOptions& caps, Corners corners);

    void begin_object(std::string name);
    /// Number of the vertex in the mesh. Errors: model_too_many_vertices, model_non_finite,
    /// mesh_scale.
    Result<std::uint32_t> add_vertex(const Vec3& position);
    /// Errors: model_too_many_faces, model_too_many_corners.
    /// @pre  `corners` are numbers that add_vertex gave
    Result<void> add_face(std::span<const std::uint32_t> corners);
    /// Colours the face that was added last: all of it, or each of its corners.
    void colour_face(const mesh::Colour& colour) { builder_.colour_face(colour); }
    void colour_face(std::span<const std::uint32_t> corners,
                     std::span<const mesh::Colour> colours) {
        builder_.colour_face(corners, colours);
    }
    void end_object();

    void warn(const char* code, std::size_t count, std::string message) {
        builder_.warn(code, count, std::move(message));
    }
    /// The scene; objects without triangles are not listed. A scene that is white all over has no
    /// colours: that is what a material is of which its file says nothing.
    mesh::ReadMeshResult take();

private:
    mesh::MeshBuilder builder_;
    Corners corners_;
    mesh::VertexTable table_;
    std::vector<mesh::ModelObject> objects_;
    mesh::ModelObject object_;
    std::uint32_t first_vertex_ = 0;  ///< of the object
};

}  // namespace ossuary::index
