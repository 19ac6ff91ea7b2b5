// Feeds arbitrary bytes to the mesh reader and to what inspects and repairs its meshes.
//
//   CC=clang CXX=clang++ cmake -B build/fuzz -DCMAKE_BUILD_TYPE=RelWithDebInfo \
//       -DOSSUARY_BUILD_FUZZERS=ON -DOSSUARY_SANITIZE=address,undefined,fuzzer-no-link
//   cmake --build build/fuzz --target read_off_fuzz
//   mkdir -p build/fuzz/found
//   build/fuzz/bin/read_off_fuzz -max_total_time=300 -max_len=4096 \
//       build/fuzz/found tests/corpus/off/ok tests/corpus/off/bad

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "engine/mesh/decimate.h"
#include "engine/mesh/halfedge_mesh.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"

namespace {

/// Aborts, which the fuzzer reports with the input.
void require(bool condition) {
    if (!condition) std::abort();
}

void check(const ossuary::TriangleMesh& mesh) {
    require(mesh.face_of_triangle.size() == mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        require(mesh.face_of_triangle[t] < mesh.face_count);
        for (const std::uint32_t vertex : mesh.triangles[t]) require(vertex < mesh.vertices.size());
    }
    for (const ossuary::Vec3& vertex : mesh.vertices) require(vertex.allFinite());

    const auto again = ossuary::read_mesh(ossuary::to_off(mesh), "written");
    require(again.ok());
    require(again->mesh.vertices == mesh.vertices && again->mesh.triangles == mesh.triangles);

    const ossuary::HalfedgeMesh surface(mesh);
    require(surface.triangle_count() + surface.report().dropped_triangles == mesh.triangles.size());
    static_cast<void>(ossuary::inspect(mesh));
    require(ossuary::decimate(mesh, {.max_triangles = 8}).triangles.size() <= 8);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ossuary::ReadMeshOptions options;
    options.max_vertices = 100'000;
    options.max_faces = 100'000;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto read = ossuary::read_mesh(bytes, "input", options);
    if (read) {
        check(read->mesh);
    } else {
        require(!read.error().message.empty());
    }
    return 0;
}
