#include "engine/mesh/decimate.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/mesh/cluster_vertices.h"
#include "engine/mesh/colours_on.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/halfedge_mesh.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/orient.h"
#include "engine/mesh/weld.h"

namespace ossuary::mesh {
namespace {

/// Triangles in an order in which neighbours follow each other, and vertices in that of their first
/// triangles: as such they take fewest bytes and are drawn fastest. Without colours, which the
/// library does not take along.
TriangleMesh in_drawing_order(const TriangleMesh& mesh) {
    if (mesh.empty()) return mesh;
    const std::size_t corners = 3 * mesh.triangles.size();
    TriangleMesh result = mesh;
    result.corner_colours = {};
    meshopt_optimizeVertexCache(result.triangles.front().data(), mesh.triangles.front().data(),
                                corners, mesh.vertices.size());
    std::vector<std::uint32_t> place(mesh.vertices.size());
    meshopt_optimizeVertexFetchRemap(place.data(), result.triangles.front().data(), corners,
                                     mesh.vertices.size());
    for (auto& triangle : result.triangles) {
        for (std::uint32_t& vertex : triangle) vertex = place[vertex];
    }
    for (std::size_t v = 0; v < place.size(); ++v) result.vertices[place[v]] = mesh.vertices[v];
    return result;
}

/// Drops unused vertices, joins the copies that parting made, and numbers the faces anew.
TriangleMesh compact(const TriangleMesh& mesh) {
    TriangleMesh result = weld(mesh).mesh;
    result.face_count = static_cast<std::uint32_t>(result.triangles.size());
    result.face_of_triangle.resize(result.triangles.size());
    std::iota(result.face_of_triangle.begin(), result.face_of_triangle.end(), 0u);
    return result;
}

/// Collapses edges by quadric error until at most `max_triangles` are left or the surface's seams
/// allow no more.
/// @pre neighbours agree in orientation
TriangleMesh collapse_edges(const TriangleMesh& mesh, std::size_t max_triangles) {
    // Around the middle, because the library works in single precision; positions stay as they are.
    const Vec3 middle = measure(mesh).bounds.center();
    std::vector<Eigen::Vector3f> positions;
    positions.reserve(mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices) positions.push_back((vertex - middle).cast<float>());
    TriangleMesh result = mesh;
    const std::size_t corners = meshopt_simplify(
        result.triangles.front().data(), mesh.triangles.front().data(), 3 * mesh.triangles.size(),
        positions.front().data(), positions.size(), sizeof(Eigen::Vector3f), 3 * max_triangles,
        std::numeric_limits<float>::max(), 0, nullptr);
    result.triangles.resize(corners / 3);
    result.corner_colours.clear();
    return result;
}

/// The most triangles at one vertex.
std::size_t greatest_valence(const TriangleMesh& mesh) {
    std::vector<std::size_t> valence(mesh.vertices.size(), 0);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) ++valence[vertex];
    }
    return valence.empty() ? 0 : *std::max_element(valence.begin(), valence.end());
}

/// The same by a half-edge mesh, which parts vertices at seams and so collapses what lies beyond;
/// several times slower, and its time grows with the square of a vertex's triangles. The mesh as
/// it is where that would take too long.
TriangleMesh collapse_edges_beyond_seams(const TriangleMesh& mesh, std::size_t max_triangles) {
    constexpr std::size_t kMostAtOneVertex = 500;
    if (greatest_valence(mesh) > kMostAtOneVertex) return mesh;
    HalfedgeMesh surface(mesh);
    surface.decimate_quadric(max_triangles);
    return surface.to_triangle_mesh();
}

/// The mesh if it has no more triangles, else about so many.
TriangleMesh at_most(const TriangleMesh& mesh, std::size_t max_triangles) {
    return mesh.triangles.size() > max_triangles ? cluster_vertices(mesh, max_triangles) : mesh;
}

}  // namespace

TriangleMesh decimate(const TriangleMesh& mesh, const DecimateOptions& options,
                      const std::stop_token& stop) {
    const std::size_t wanted = options.max_triangles;
    TriangleMesh welded = compact(mesh);
    if (stop.stop_requested()) return welded;
    if (welded.triangles.size() <= wanted) return welded;
    // So many take a tenth of a second, and a third of that.
    const std::size_t many = std::max<std::size_t>(150'000, 3 * wanted);
    const std::size_t few = std::max<std::size_t>(6000, 3 * wanted);
    const TriangleMesh fine =
        welded.triangles.size() > many ? cluster_vertices(welded, many) : std::move(welded);
    TriangleMesh coarse = collapse_edges(sides_agree(fine) ? fine : orient(fine).mesh, wanted);
    if (coarse.triangles.size() > wanted && !stop.stop_requested()) {
        coarse = collapse_edges_beyond_seams(orient(at_most(fine, few)).mesh, wanted);
    }
    if (coarse.triangles.size() > wanted) coarse = cluster_vertices(fine, wanted);
    // Once more, since it may face inwards all over.
    coarse = in_drawing_order(orient(compact(coarse)).mesh);
    coarse.corner_colours = colours_on(coarse, fine);
    return coarse;
}

}  // namespace ossuary::mesh
