#include "engine/decomposition/vertex_graph.h"

#include <cmath>

#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/vertex_normals.h"

namespace ossuary::decomposition {

VertexGraph vertex_graph(const mesh::TriangleMesh& mesh) {
    VertexGraph graph;
    graph.normals = mesh::vertex_normals(mesh);
    const mesh::EdgeTable table = mesh::build_edge_table(mesh);
    graph.first.assign(mesh.vertices.size() + 1, 0);
    for (const mesh::EdgeTable::Edge& edge : table.edges) {
        ++graph.first[edge.a + 1];
        ++graph.first[edge.b + 1];
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) graph.first[v + 1] += graph.first[v];
    graph.neighbors.resize(2 * table.edges.size());
    std::vector<std::uint32_t> next(graph.first.begin(), graph.first.end() - 1);
    for (const mesh::EdgeTable::Edge& edge : table.edges) {
        graph.neighbors[next[edge.a]++] = edge.b;
        graph.neighbors[next[edge.b]++] = edge.a;
    }
    const double scale = std::sqrt(mesh::measure(mesh).surface_area);
    graph.curvatures.assign(mesh.vertices.size(), 0.0);
    for (std::uint32_t v = 0; v < graph.size(); ++v) {
        const auto around = graph.around(v);
        for (const std::uint32_t n : around) {
            const Vec3 step = mesh.vertices[n] - mesh.vertices[v];
            const double squared = step.squaredNorm();
            if (squared <= 0.0) continue;
            graph.curvatures[v] += scale * (graph.normals[n] - graph.normals[v]).dot(step) /
                                   (squared * static_cast<double>(around.size()));
        }
    }
    return graph;
}

}  // namespace ossuary::decomposition
