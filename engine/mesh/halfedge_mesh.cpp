#include "engine/mesh/halfedge_mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cassert>

#include "engine/mesh/manifold_fans.h"

namespace ossuary::mesh {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Traits>;

}  // namespace

struct HalfedgeMesh::Implementation {
    Surface surface;
    HalfedgeReport report;
    std::vector<std::uint32_t> source_vertex;
};

HalfedgeMesh::HalfedgeMesh(const TriangleMesh& mesh)
    : implementation_(std::make_unique<Implementation>()) {
    Surface& surface = implementation_->surface;
    HalfedgeReport& report = implementation_->report;
    ManifoldFans fans = part_into_fans(mesh);
    report.dropped_triangles = fans.dropped_triangles;
    report.duplicated_vertices = fans.duplicated_vertices;

    const auto add_vertex = [&](std::uint32_t source) {
        const Vec3& position = mesh.vertices[source];
        return surface.add_vertex({position.x(), position.y(), position.z()});
    };
    surface.reserve(fans.source_vertex.size(), 3 * fans.triangles.size() / 2,
                    fans.triangles.size());
    for (const std::uint32_t source : fans.source_vertex) add_vertex(source);
    for (const auto& triangle : fans.triangles) {
        std::array<Surface::VertexHandle, 3> corners;
        bool fits = true;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = Surface::VertexHandle(static_cast<int>(triangle[i]));
            fits = fits && surface.is_boundary(corners[i]);
        }
        // Asked beforehand, because OpenMesh reports a misfit on its error stream.
        for (std::size_t i = 0; i < 3 && fits; ++i) {
            const auto existing = surface.find_halfedge(corners[i], corners[(i + 1) % 3]);
            fits = !existing.is_valid() || surface.is_boundary(existing);
        }
        if (fits && surface.add_face(corners.data(), 3).is_valid()) continue;
        // Rare: two edges between the same vertices, or a gap in a fan that cannot be re-linked.
        ++report.detached_triangles;
        report.duplicated_vertices += 3;
        for (std::size_t i = 0; i < 3; ++i) {
            fans.source_vertex.push_back(fans.source_vertex[triangle[i]]);
            corners[i] = add_vertex(fans.source_vertex.back());
        }
        surface.add_face(corners.data(), 3);
    }
    implementation_->source_vertex = std::move(fans.source_vertex);
}

HalfedgeMesh::~HalfedgeMesh() = default;
HalfedgeMesh::HalfedgeMesh(HalfedgeMesh&& other) noexcept = default;
HalfedgeMesh& HalfedgeMesh::operator=(HalfedgeMesh&& other) noexcept = default;

const HalfedgeReport& HalfedgeMesh::report() const { return implementation_->report; }
std::size_t HalfedgeMesh::vertex_count() const { return implementation_->surface.n_vertices(); }
std::size_t HalfedgeMesh::edge_count() const { return implementation_->surface.n_edges(); }
std::size_t HalfedgeMesh::triangle_count() const { return implementation_->surface.n_faces(); }

std::size_t HalfedgeMesh::boundary_loop_count() const {
    const Surface& surface = implementation_->surface;
    std::vector<std::uint8_t> seen(surface.n_halfedges(), 0);
    std::size_t loops = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        auto halfedge = Surface::HalfedgeHandle(static_cast<int>(i));
        if (seen[i] != 0 || !surface.is_boundary(halfedge)) continue;
        ++loops;
        while (seen[static_cast<std::size_t>(halfedge.idx())] == 0) {
            seen[static_cast<std::size_t>(halfedge.idx())] = 1;
            halfedge = surface.next_halfedge_handle(halfedge);
        }
    }
    return loops;
}

bool HalfedgeMesh::is_boundary(std::uint32_t vertex) const {
    assert(vertex < vertex_count());
    return implementation_->surface.is_boundary(Surface::VertexHandle(static_cast<int>(vertex)));
}

std::uint32_t HalfedgeMesh::source_vertex(std::uint32_t vertex) const {
    assert(vertex < implementation_->source_vertex.size());
    return implementation_->source_vertex[vertex];
}

std::vector<std::uint32_t> HalfedgeMesh::one_ring(std::uint32_t vertex) const {
    assert(vertex < vertex_count());
    std::vector<std::uint32_t> ring;
    const Surface& surface = implementation_->surface;
    for (auto neighbor = surface.cvv_iter(Surface::VertexHandle(static_cast<int>(vertex)));
         neighbor.is_valid(); ++neighbor) {
        ring.push_back(static_cast<std::uint32_t>(neighbor->idx()));
    }
    return ring;
}

std::size_t HalfedgeMesh::decimate_quadric(std::size_t max_triangles) {
    Surface& surface = implementation_->surface;
    if (surface.n_faces() <= max_triangles) return surface.n_faces();
    {
        OpenMesh::Decimater::DecimaterT<Surface> decimater(surface);
        OpenMesh::Decimater::ModQuadricT<Surface>::Handle quadric;
        decimater.add(quadric);
        const bool ready = decimater.initialize();
        assert(ready);
        if (ready) decimater.decimate_to_faces(0, max_triangles);
    }
    surface.garbage_collection();
    implementation_->source_vertex.clear();
    return surface.n_faces();
}

TriangleMesh HalfedgeMesh::to_triangle_mesh() const {
    const Surface& surface = implementation_->surface;
    TriangleMesh mesh;
    mesh.vertices.reserve(surface.n_vertices());
    for (std::size_t v = 0; v < surface.n_vertices(); ++v) {
        const auto& p = surface.point(Surface::VertexHandle(static_cast<int>(v)));
        mesh.vertices.emplace_back(p[0], p[1], p[2]);
    }
    mesh.triangles.reserve(surface.n_faces());
    for (std::size_t f = 0; f < surface.n_faces(); ++f) {
        TriangleMesh::Triangle triangle{};
        std::size_t corner = 0;
        for (auto v = surface.cfv_iter(Surface::FaceHandle(static_cast<int>(f))); v.is_valid();
             ++v) {
            triangle[corner++] = static_cast<std::uint32_t>(v->idx());
        }
        mesh.face_of_triangle.push_back(static_cast<std::uint32_t>(f));
        mesh.triangles.push_back(triangle);
    }
    mesh.face_count = static_cast<std::uint32_t>(mesh.triangles.size());
    return mesh;
}

}  // namespace ossuary::mesh
