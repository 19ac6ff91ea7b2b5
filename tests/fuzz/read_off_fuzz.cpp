// Feeds arbitrary bytes to the mesh reader and to what inspects and repairs its meshes.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/mesh/body.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/halfedge_mesh.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "tests/fuzz/require.h"

namespace {

using ossuary::fuzz::require;

void check(const ossuary::mesh::TriangleMesh& mesh) {
    require(mesh.face_of_triangle.size() == mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        require(mesh.face_of_triangle[t] < mesh.face_count);
        for (const std::uint32_t vertex : mesh.triangles[t]) require(vertex < mesh.vertices.size());
    }
    for (const ossuary::Vec3& vertex : mesh.vertices) require(vertex.allFinite());

    const auto again = ossuary::mesh::read_mesh(ossuary::mesh::to_off(mesh), "written");
    require(again.ok());
    require(again->mesh.vertices == mesh.vertices && again->mesh.triangles == mesh.triangles);

    const ossuary::mesh::HalfedgeMesh surface(mesh);
    require(surface.triangle_count() + surface.report().dropped_triangles == mesh.triangles.size());
    static_cast<void>(ossuary::mesh::inspect(mesh));
    require(ossuary::mesh::decimate(mesh, {.max_triangles = 8}).triangles.size() <= 8);
    const ossuary::mesh::Body body = ossuary::mesh::find_body(mesh);
    require(body.of(mesh).triangles.size() <= mesh.triangles.size());
    require(body.of(mesh).empty() == mesh.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ossuary::mesh::ReadMeshOptions options;
    options.max_vertices = 100'000;
    options.max_faces = 100'000;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto read = ossuary::mesh::read_mesh(bytes, "input", options);
    if (read) {
        check(read->mesh);
    } else {
        require(!read.error().message.empty());
    }
    return 0;
}
