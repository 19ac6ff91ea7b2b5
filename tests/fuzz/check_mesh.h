#pragma once

#include <cstdint>
#include <string_view>

#include "engine/mesh/body.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/halfedge_mesh.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/read_off.h"
#include "engine/mesh/write_mesh.h"
#include "tests/fuzz/require.h"

namespace ossuary::fuzz {

/// What any mesh that was read must be good for: indices in range, finite coordinates, written and
/// read again the same, inspected and repaired.
inline void check_mesh(const mesh::TriangleMesh& mesh) {
    require(mesh.face_of_triangle.size() == mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        require(mesh.face_of_triangle[t] < mesh.face_count);
        for (const std::uint32_t vertex : mesh.triangles[t]) require(vertex < mesh.vertices.size());
    }
    for (const Vec3& vertex : mesh.vertices) require(vertex.allFinite());

    const auto again = mesh::read_off(mesh::to_off(mesh), "written");
    require(again.ok());
    require(again->mesh.vertices == mesh.vertices && again->mesh.triangles == mesh.triangles);

    const mesh::HalfedgeMesh surface(mesh);
    require(surface.triangle_count() + surface.report().dropped_triangles == mesh.triangles.size());
    static_cast<void>(mesh::inspect(mesh));
    require(mesh::decimate(mesh, {.max_triangles = 8}).triangles.size() <= 8);
    const mesh::Body body = mesh::find_body(mesh);
    require(body.of(mesh).triangles.size() <= mesh.triangles.size());
    require(body.of(mesh).empty() == mesh.empty());
}

using Reader = Result<mesh::ReadMeshResult>(std::string_view bytes, std::string_view name,
                                            const mesh::ReadMeshOptions& options,
                                            const std::stop_token& stop);

/// Gives arbitrary bytes to a reader, and its mesh to check_mesh.
inline void check_reader(Reader& reader, const std::uint8_t* data, std::size_t size) {
    mesh::ReadMeshOptions options;
    options.max_vertices = 100'000;
    options.max_faces = 100'000;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Result<mesh::ReadMeshResult> read = reader(bytes, "input", options, {});
    if (read) {
        check_mesh(read->mesh);
    } else {
        require(!read.error().message.empty());
    }
}

}  // namespace ossuary::fuzz
