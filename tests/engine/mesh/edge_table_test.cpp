#include "engine/mesh/edge_table.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

TEST(EdgeTable, HoldsEverySideOnceUnderItsEdge) {
    mesh::TriangleMesh mesh = renumbered(joined(torus_mesh(7, 5), square_mesh(3)), 3);
    // A hub with more edges than are sorted by insertion.
    for (std::uint32_t v = 1; v + 1 < mesh.vertices.size(); v += 2) {
        mesh.triangles.push_back({0, v, v + 1});
    }
    mesh.triangles.push_back({4, 4, 5});
    const mesh::EdgeTable table = mesh::build_edge_table(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> expected;
    for (std::size_t t = 0; t + 1 < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            ++expected[std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])];
        }
    }
    ASSERT_EQ(table.edges.size(), expected.size());
    auto next = expected.begin();
    for (const mesh::EdgeTable::Edge& edge : table.edges) {
        EXPECT_EQ(std::make_pair(edge.a, edge.b), next->first);
        EXPECT_EQ(edge.side_count, next->second);
        for (const std::uint32_t side : table.sides_of(edge)) {
            const auto& triangle = mesh.triangles[side / 3];
            const auto from = triangle[side % 3];
            const auto to = triangle[(side % 3 + 1) % 3];
            EXPECT_EQ(std::minmax(from, to), std::minmax(edge.a, edge.b));
            EXPECT_EQ(mesh::goes_up(mesh, side), from < to);
        }
        ++next;
    }
}

TEST(AdjacentTriangles, AreMutualAndShareAnEdge) {
    const mesh::TriangleMesh mesh = torus_mesh(7, 5);
    const auto adjacent = mesh::adjacent_triangles(mesh, mesh::build_edge_table(mesh));
    for (std::uint32_t t = 0; t < adjacent.size(); ++t) {
        for (const std::uint32_t other : adjacent[t]) {
            ASSERT_NE(other, mesh::kNoTriangle);
            EXPECT_EQ(std::count(adjacent[other].begin(), adjacent[other].end(), t), 1);
        }
    }
}

TEST(AdjacentTriangles, EndAtBoundaries) {
    const mesh::TriangleMesh mesh = square_mesh(4);
    std::size_t ends = 0;
    for (const auto& sides : mesh::adjacent_triangles(mesh, mesh::build_edge_table(mesh))) {
        ends += static_cast<std::size_t>(std::count(sides.begin(), sides.end(), mesh::kNoTriangle));
    }
    EXPECT_EQ(ends, 16u);
}

}  // namespace
}  // namespace ossuary::test
